"""Users, API keys, sessions and the audit log in SQLite and PostgreSQL."""

from __future__ import annotations

import hashlib
import re
import sqlite3
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import pytest

from knifetip.contract.job import Actor, ActorKind
from knifetip.errors import NotFound, RequestError, WrongState
from knifetip.messages import Message
from knifetip.service.accounts.audit_store import AuditFilter
from knifetip.service.accounts.key_store import USE_INTERVAL
from knifetip.service.accounts.session_store import IDLE, LIFETIME
from knifetip.service.database.acting import DONE, ActingPrincipal, acting_as, signature
from knifetip.service.http.scopes import AccessScope
from knifetip.service.store import Store

VIEWER, DESIGNER, OPERATOR, ADMIN, GATEWAY = list(AccessScope)[:5]
PASSWORD = "four words of text"
ANNA = ActingPrincipal("user", "anna", "u1", "release_job", "job", "j1", "10.0.0.7")


class Clock:
    """A clock that a test sets."""

    now = 1_000_000.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


def test_a_user_signs_in_with_the_password_only(store: Store) -> None:
    assert not store.users.has_admin()
    row = store.users.add("Anna", PASSWORD, ADMIN, "bob")
    assert (row.name, row.role, row.created_by) == ("anna", "admin", "bob")
    assert store.users.has_admin()
    assert re.match(r"\$argon2id\$v=19\$m=19456,t=2,p=1\$", row.password)
    assert PASSWORD not in row.password
    found = store.users.authenticate("ANNA", PASSWORD)
    assert found is not None
    assert found.id == row.id
    for name, password in (("anna", PASSWORD + "x"), ("anna", ""), ("bob", PASSWORD)):
        assert store.users.authenticate(name, password) is None
    assert store.users.authenticate("anna", "x" * 100_000) is None


@pytest.mark.parametrize("name", ["", "a b", "a/b", "-a", "ä", "a" * 65, "a\x1b[2J", "<b>"])
def test_names_of_users_are_plain(store: Store, name: str) -> None:
    with pytest.raises(RequestError, match="name"):
        store.users.add(name, PASSWORD, VIEWER)


def test_passwords_have_ten_characters_at_least(store: Store) -> None:
    with pytest.raises(RequestError, match="9 characters"):
        store.users.add("anna", "x" * 9, VIEWER)
    store.users.add("anna", "zvokfmhqea", VIEWER)
    with pytest.raises(WrongState, match="already"):
        store.users.add("ANNA", PASSWORD, VIEWER)
    with pytest.raises(RequestError, match="gateway"):
        store.users.add("table", PASSWORD, GATEWAY)


def test_there_is_always_an_active_administrator(store: Store) -> None:
    store.users.add("anna", PASSWORD, ADMIN)
    for change in ({"role": OPERATOR}, {"active": False}):
        with pytest.raises(WrongState, match="last active administrator"):
            store.users.change("anna", **change)
    store.users.add("bob", PASSWORD, ADMIN)
    store.users.change("anna", active=False)
    assert store.users.authenticate("anna", PASSWORD) is None
    with pytest.raises(WrongState):
        store.users.change("bob", role=VIEWER)
    store.users.change("anna", active=True)
    store.users.change("bob", role=VIEWER)
    with pytest.raises(NotFound):
        store.users.change("carl", role=VIEWER)


def test_a_session_ends_when_it_is_idle_or_old(store: Store, clock: Clock) -> None:
    user = store.users.add("anna", PASSWORD, VIEWER)
    idle, used = store.sessions.open(user), store.sessions.open(user)
    began = clock.now
    while clock.now < began + LIFETIME:
        found = store.sessions.find(used)
        assert found is not None
        assert found.name == "anna"
        clock.now += IDLE - 1.0
    assert store.sessions.find(used) is None
    assert store.sessions.find(idle) is None
    last = store.sessions.open(user)
    clock.now += IDLE
    assert store.sessions.find(last) is None
    assert store.sessions.find("") is None


def test_a_session_ends_at_sign_out_and_when_its_user_changes(store: Store) -> None:
    user = store.users.add("anna", PASSWORD, VIEWER)
    first, second = store.sessions.open(user), store.sessions.open(user)
    store.sessions.close(first)
    assert store.sessions.find(first) is None
    assert store.sessions.find(second) is not None
    changes: tuple[dict[str, Any], ...] = (
        {"role": DESIGNER},
        {"password": PASSWORD},
        {"active": True},
        {"active": False},
    )
    for change in changes:
        token = store.sessions.open(user)
        store.users.change("anna", **change)
        assert store.sessions.find(token) is None, change


def test_a_key_is_found_by_its_whole_secret(store: Store, clock: Clock) -> None:
    row, secret = store.keys.add(" ERP ", [OPERATOR, GATEWAY], clock.now + 100.0, "anna")
    assert re.fullmatch(r"kt_[a-z0-9]{10}_[A-Za-z0-9_-]{43}", secret)
    assert (row.title, row.scopes) == ("ERP", ["gateway", "operator"])
    assert row.digest == hashlib.sha256(secret.encode()).hexdigest()
    assert store.keys.find(secret) is not None
    other = store.keys.add("other", [VIEWER])[1]
    mixed = f"kt_{row.id}_{other[-43:]}"
    for wrong in (secret[:-1], secret + "x", mixed, f"kt_{row.id}_", "", "kt__", "\udcff"):
        assert store.keys.find(wrong) is None
    clock.now += 100.0
    assert store.keys.find(secret) is None
    assert store.keys.find(other) is not None
    for title, scopes in (("", [VIEWER]), ("x", [])):
        with pytest.raises(RequestError):
            store.keys.add(title, scopes)
    with pytest.raises(WrongState) as refused:
        store.keys.add("x", [VIEWER], clock.now)
    assert refused.value.message.code == "key.expired-at-once"


def test_a_revoked_key_stays_in_the_list(store: Store, clock: Clock) -> None:
    row, secret = store.keys.add("ERP", [VIEWER])
    store.keys.revoke(row.id)
    at = clock.now
    clock.now += 5.0
    store.keys.revoke(row.id)
    assert store.keys.find(secret) is None
    assert [one.revoked for one in store.keys.all()] == [at]
    with pytest.raises(NotFound):
        store.keys.revoke("x")


def test_the_use_of_a_key_is_written_once_a_minute(store: Store, clock: Clock) -> None:
    _, secret = store.keys.add("ERP", [VIEWER])
    first = clock.now
    for _ in range(3):
        assert store.keys.find(secret) is not None
        clock.now += USE_INTERVAL / 3 - 0.1
    assert store.keys.all()[0].used == first
    clock.now += 1.0
    store.keys.find(secret)
    assert store.keys.all()[0].used == clock.now


def test_no_secret_is_in_the_database(tmp_path: Path) -> None:
    store = Store(f"sqlite:///{tmp_path}/a.sqlite")
    store.migrate()
    user = store.users.add("anna", PASSWORD, ADMIN)
    token = store.sessions.open(user)
    _, secret = store.keys.add("ERP", [VIEWER])
    store.close()
    dump = "\n".join(sqlite3.connect(tmp_path / "a.sqlite").iterdump())
    for hidden in (PASSWORD, token, secret, secret[-43:]):
        assert hidden not in dump
    assert user.password in dump


def write(store: Store, subject: str, *, fails: bool = False) -> None:
    """Write an event of a job in a transaction, which may fail."""
    with store.database.writing() as session:
        store.jobs._transitions.write_job_event(
            session, subject, "ready", Actor(ActorKind.OPERATOR), Message("job.released")
        )
        if fails:
            raise ZeroDivisionError


def test_an_entry_of_the_audit_log_is_in_the_transaction_of_its_request(store: Store) -> None:
    def acting(subject: str = "") -> ActingPrincipal:
        return ActingPrincipal("user", "anna", "u1", "order_job", "job", subject, "10.0.0.7")

    failing = acting()
    with acting_as(failing), pytest.raises(ZeroDivisionError):
        write(store, "j1", fails=True)
    assert not failing.written
    assert store.audit.search(AuditFilter()) == []
    assert store.events.last_id() == 0
    with acting_as(acting()):
        write(store, "j2")
        write(store, "j3")
    rows = store.audit.search(AuditFilter())
    assert [(row.principal, row.action, row.subject_kind, row.subject, row.outcome, row.peer)
            for row in rows] == [("anna", "order_job", "job", "j2", DONE, "10.0.0.7")]  # fmt: skip
    write(store, "j4")
    assert len(store.audit.search(AuditFilter())) == 1


def test_the_audit_log_is_searched_and_paged(store: Store, clock: Clock) -> None:
    for number in range(5):
        acting = ActingPrincipal("key", f"k{number % 2}", "", "scrap_job", "job", f"j{number}")
        store.audit.write(acting, DONE)
        clock.now += 1.0
    newest = store.audit.search(AuditFilter(), limit=2)
    assert [row.subject for row in newest] == ["j4", "j3"]
    older = store.audit.search(AuditFilter(), newest[-1].id, 2)
    assert [row.subject for row in older] == ["j2", "j1"]
    assert [row.subject for row in store.audit.search(AuditFilter(principal="k1"))] == ["j3", "j1"]
    since = AuditFilter(since=clock.now - 2.0, until=clock.now - 1.0)
    assert [row.subject for row in store.audit.search(since)] == ["j3"]


def test_events_name_the_account_and_keep_the_claimed_name() -> None:
    def who(claimed: str, acting: ActingPrincipal | None) -> str:
        with nullcontext() if acting is None else acting_as(acting):
            return signature(Actor(ActorKind.OPERATOR, claimed))

    local = ActingPrincipal("local", "local", "", "release_job")
    assert who("", None) == "operator"
    assert who("Ben", local) == "operator Ben"
    assert who("", ANNA) == "operator anna"
    assert who("anna", ANNA) == "operator anna"
    assert who("Ben", ANNA) == "operator anna (Ben)"
    with acting_as(ANNA):
        assert signature(Actor(ActorKind.GATEWAY, "table")) == "gateway table"
