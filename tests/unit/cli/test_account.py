"""The commands ``user`` and ``key`` on a database, and the keys that they write to files."""

from __future__ import annotations

import io
import json
import stat
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from knifetip.cli.access_key import KeyOptions
from knifetip.service.accounts.audit_store import AuditFilter
from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store
from tests.support.command import Command
from tests.support.hostile_names import HOSTILE_NAMES, acting

PASSWORD = "four words of text"
Account = Callable[..., tuple[int, str, str]]


@pytest.fixture
def url(tmp_path: Path) -> str:
    return f"sqlite:///{tmp_path}/a.sqlite"


@pytest.fixture
def store(url: str) -> Iterator[Store]:
    opened = Store(url)
    opened.migrate()
    yield opened
    opened.close()


@pytest.fixture
def account(knifetip: Command, url: str, monkeypatch: pytest.MonkeyPatch) -> Account:
    """Return a function that runs a command with a password on stdin."""

    def run(*words: object, password: str = PASSWORD) -> tuple[int, str, str]:
        monkeypatch.setattr("sys.stdin", io.StringIO(password + "\n"))
        return knifetip(*words, "--database", url)

    return run


def test_users_are_added_listed_and_changed(account: Account, store: Store) -> None:
    assert account("user", "add", "Anna", "--role", "admin")[:2] == (0, "anna: admin\n")
    assert account("user", "add", "carol")[1] == "carol: viewer\n"
    code, out, _ = account("user", "list", "--json")
    rows = {row["name"]: row for row in json.loads(out)}
    assert code == 0
    assert {name: (row["role"], row["active"]) for name, row in rows.items()} == {
        "anna": ("admin", True),
        "carol": ("viewer", True),
    }
    assert "password" not in out
    carol = store.users.authenticate("carol", PASSWORD)
    assert carol is not None
    token = store.sessions.open(carol)
    assert account("user", "role", "carol", "operator")[0] == 0
    assert store.sessions.find(token) is None
    assert account("user", "password", "carol", password="another long text")[0] == 0
    assert store.users.authenticate("carol", PASSWORD) is None
    assert store.users.authenticate("carol", "another long text") is not None
    assert account("user", "disable", "carol")[0] == 0
    assert store.users.authenticate("carol", "another long text") is None
    assert "carol                operator  last sign-in 20" in account("user", "list")[1]
    assert "(disabled)" in account("user", "list")[1]
    assert account("user", "enable", "carol")[0] == 0
    found = store.users.authenticate("carol", "another long text")
    assert found is not None
    assert found.role == "operator"


@pytest.mark.parametrize(
    ("words", "password", "said"),
    [
        (("user", "add", "anna"), PASSWORD, "anna"),
        (("user", "add", "bob"), "short", "10"),
        (("user", "add", "bob", "--role", "gateway"), PASSWORD, "gateway"),
        (("user", "disable", "anna"), "", "administrator"),
        (("user", "role", "anna", "viewer"), "", "administrator"),
        (("user", "password", "nobody"), PASSWORD, "nobody"),
        (("key", "revoke", "nothing"), "", "nothing"),
        (("key", "create", " ", "--scope", "viewer"), "", "title"),
    ],
)
def test_a_wrong_command_reports_the_error_and_changes_nothing(
    account: Account, store: Store, words: tuple[str, ...], password: str, said: str
) -> None:
    account("user", "add", "anna", "--role", "admin")
    code, out, err = account(*words, password=password)
    assert (code, out) == (3, "")
    assert said in err
    assert "Traceback" not in err
    assert [(row.name, row.role, row.active) for row in store.users.all()] == [
        ("anna", "admin", True)
    ]
    assert not store.keys.all()
    assert store.users.authenticate("anna", PASSWORD) is not None


def test_a_key_is_printed_once_listed_and_revoked(account: Account, store: Store) -> None:
    words = ("key", "create", "ERP", "--scope", "designer", "--scope", "gateway", "--days", "2")
    code, out, err = account(*words)
    secret = out.strip()
    found = store.keys.find(secret)
    assert found is not None
    assert (code, found.title, found.scopes) == (0, "ERP", ["designer", "gateway"])
    assert found.expires is not None
    assert 1.9 < (found.expires - found.created) / 86_400 < 2.1
    assert secret not in err
    code, out, _ = account("key", "list", "--json")
    assert [(row["id"], row["revoked"]) for row in json.loads(out)] == [(found.id, None)]
    assert secret.rpartition("_")[2] not in out
    assert found.digest not in out
    assert account("key", "revoke", found.id)[0] == 0
    assert store.keys.find(secret) is None
    assert "revoked 20" in account("key", "list")[1]


def test_a_key_in_a_file_is_created_once(account: Account, store: Store, tmp_path: Path) -> None:
    file = tmp_path / "gateway"
    words = ("key", "create", "table 1", "--scope", "gateway", "--file", file)
    code, out, _ = account(*words)
    secret = file.read_text().strip()
    assert (code, out) == (0, "")
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert KeyOptions(key_file=file).headers == {"Authorization": f"Bearer {secret}"}
    (row,) = store.keys.all()
    assert (row.title, row.scopes, row.used) == ("table 1", ["gateway"], None)
    assert account(*words)[0] == 0
    assert file.read_text().strip() == secret
    assert len(store.keys.all()) == 1
    # A key that is no longer valid, or of another database, or with other scopes, is replaced.
    store.keys.revoke(row.id)
    for number, change in enumerate(("", "kt_0000000000_" + 43 * "x", "\udcff", None)):
        if change is None:
            file.write_text(store.keys.add("erp", [AccessScope.ADMIN])[1])
        elif change:
            file.write_text(change, errors="surrogateescape")
        assert account(*words)[0] == 0, number
        found = store.keys.find(file.read_text().strip())
        assert found is not None
        assert found.scopes == ["gateway"]
    assert [path.name for path in tmp_path.iterdir() if "gateway" in path.name] == ["gateway"]


def test_no_key_is_created_if_its_file_cannot_be_written(
    account: Account, store: Store, tmp_path: Path
) -> None:
    file = tmp_path / "no such folder" / "gateway"
    code, _, err = account("key", "create", "table 1", "--scope", "gateway", "--file", file)
    assert code == 3
    assert str(file) in err
    assert not store.keys.all()


@pytest.mark.parametrize(
    "name", [*HOSTILE_NAMES.values(), 10_000 * "long "], ids=[*HOSTILE_NAMES, "long"]
)
def test_hostile_titles_and_names_are_harmless_in_the_terminal(
    account: Account, store: Store, name: str
) -> None:
    code, out, err = account("key", "create", name, "--scope", "viewer")
    assert code in (0, 3)
    for text in (out, err, account("key", "list")[1], *account("user", "add", name)[1:]):
        assert not acting(text, "\n")
        assert len(text) < 1000
        assert "Traceback" not in text
    assert not store.users.all()


def test_each_change_is_in_the_audit_log(account: Account, store: Store) -> None:
    account("user", "add", "anna", "--role", "admin")
    account("user", "add", "carol")
    account("user", "role", "carol", "operator")
    account("user", "password", "carol", password="another long text")
    account("user", "disable", "carol")
    account("user", "enable", "carol")
    account("user", "disable", "anna")  # refused: the last administrator
    account("user", "list")
    key = store.keys.find(account("key", "create", "ERP", "--scope", "viewer")[1].strip())
    assert key is not None
    account("key", "revoke", key.id)
    rows = store.audit.search(AuditFilter())
    assert {(row.kind, row.principal, row.outcome) for row in rows} == {
        ("command", "command line", "done")
    }
    assert [(row.action, row.subject_kind, row.subject) for row in reversed(rows)] == [
        ("create_user", "user", "anna"),
        ("create_user", "user", "carol"),
        *[("change_user", "user", "carol")] * 4,
        ("create_key", "key", key.id),
        ("revoke_key", "key", key.id),
    ]


def test_a_key_has_limits_and_a_new_secret_under_the_same_id(
    account: Account, store: Store, tmp_path: Path
) -> None:
    create = ("key", "create", "ERP", "--scope", "order", "--customer", "ACME")
    file = tmp_path / "key"
    assert account(*create, "--machine", "demo-table", "--file", file)[0] == 0
    (row,) = store.keys.all()
    assert (row.customer, row.machines, row.any_machine) == ("ACME", ["demo-table"], False)
    assert "customer ACME, machines demo-table" in account("key", "list")[1]
    # A key with other limits is not the wanted one.
    account(*create, "--machine", "demo-table", "--file", file)
    assert len(store.keys.all()) == 1
    account(*create, "--machine", "router-table", "--file", file)
    assert len(store.keys.all()) == 2
    former = file.read_text().strip()
    id = next(one.id for one in store.keys.all() if one.machines == ["router-table"])
    code, out, _ = account("key", "rotate", id)
    assert code == 0
    assert store.keys.find(former) is None
    found = store.keys.find(out.strip())
    assert found is not None
    assert found.id == id
    code, _, err = account(*create, "--machine", "none")
    assert code != 0
    assert "none" in err
