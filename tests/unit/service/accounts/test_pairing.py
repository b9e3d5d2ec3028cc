"""A browser is paired with a machine by a code, and may then work at this machine alone."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import pytest
import sqlalchemy as sa

from knifetip.service.accounts import access, account_access
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.accounts.pairing_store import CODE_LIFETIME
from knifetip.service.accounts.sign_in_throttle import FREE
from knifetip.service.database.account_tables import ApiKey, PairingCode
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from tests.support.serving.server import LocalClient, order_job, run_server, square, upload_drawing

PASSWORD = "four words of text"
MACHINE, OTHER = "demo-table", "v-groove-table"
CODES = f"/api/v1/machines/{MACHINE}/pairing-codes"
DEVICES = f"/api/v1/machines/{MACHINE}/devices"
#: A browser sends this with the forms of the server's own pages.
BROWSER = "Mozilla/5.0 (Tablet)"


@pytest.fixture
def server(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[LocalClient]:
    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 0.0)
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", compiles=False)) as client:
        yield client


@pytest.fixture
def admin(server: LocalClient) -> Iterator[httpx.Client]:
    user = {"name": "anna", "password": PASSWORD, "role": "admin"}
    assert server.post("/api/users", json=user).status_code == 201
    with browser(server) as client:
        sent = {"name": "anna", "password": PASSWORD}
        assert client.post("/api/session", json=sent).status_code == 200
        yield client


def browser(server: httpx.Client, **headers: str) -> httpx.Client:
    own = {"X-Knifetip": "page", "User-Agent": BROWSER, **headers}
    return httpx.Client(base_url=server.base_url, trust_env=False, timeout=60.0, headers=own)


def enter(client: httpx.Client, code: str, device: str = "Tablet") -> httpx.Response:
    """Send the form of the page, as a browser does."""
    origin = f"http://127.0.0.1:{client.base_url.port}"
    fields = {"code": code, "device": device}
    return client.post("/pair", data=fields, headers={"Origin": origin})


@contextmanager
def paired(
    server: httpx.Client, admin: httpx.Client, device: str = "Tablet"
) -> Iterator[httpx.Client]:
    """Return a browser that is paired with the machine."""
    with browser(server) as client:
        answer = enter(client, admin.post(CODES).json()["code"], device)
        assert answer.status_code == 200, answer.text
        yield client


def test_a_code_pairs_a_browser_with_its_machine(server: LocalClient, admin: httpx.Client) -> None:
    made = admin.post(CODES)
    assert made.status_code == 201
    assert made.headers["cache-control"] == "no-store"
    code = made.json()["code"]
    assert len(code.replace("-", "")) == 8
    assert not set(code) & set("01IOLU"), "characters that are mistaken for one another"
    with browser(server) as tablet:
        assert tablet.get("/api/me").status_code == 401
        page = tablet.get("/pair")
        assert (page.status_code, 'name="code"' in page.text) == (200, True)
        answer = enter(tablet, f" {code.lower().replace('-', ' ')} ")
        assert f"url=/#/station/{MACHINE}" in answer.text
        cookie = answer.headers["set-cookie"].lower()
        for word in ("httponly", "samesite=strict", "path=/"):
            assert word in cookie
        me = tablet.get("/api/me").json()
        assert (me["kind"], me["name"], me["machines"]) == ("device", "Tablet", [MACHINE])
        assert set(me["scopes"]) == {"viewer", "station"}
    row = server.service.store.keys.all()[0]
    assert (row.scopes, row.machines, row.device) == (["station"], [MACHINE], True)
    entries = admin.get("/api/audit").json()
    assert [(one["action"], one["subject"], one["outcome"]) for one in entries[:2]] == [
        ("pair_device", MACHINE, "done"),
        ("create_pairing_code", MACHINE, "done"),
    ]


def test_a_device_works_at_its_machine_and_at_no_other(
    server: LocalClient, admin: httpx.Client
) -> None:
    drawing = upload_drawing(admin, square())["id"]
    own = order_job(admin, drawing, machine=MACHINE)["id"]
    other = order_job(admin, drawing, machine=OTHER)["id"]
    with paired(server, admin) as tablet:
        assert [row["id"] for row in tablet.get("/api/jobs").json()] == [own]
        assert tablet.get(f"/api/jobs/{other}").status_code == 404
        hands = tablet.post(f"/api/machines/{MACHINE}/hands-clear")
        assert hands.status_code == 200, hands.text
        assert tablet.post(f"/api/machines/{OTHER}/hands-clear").status_code == 404
        # It starts no job that is not queued, but it may ask for it.
        assert tablet.post(f"/api/jobs/{own}/confirm", json={"checked": []}).status_code == 409
        for method, path in (
            ("POST", f"/api/jobs/{own}/release"),
            ("POST", "/api/jobs"),
            ("POST", CODES),
            ("GET", DEVICES),
            ("GET", "/api/keys"),
            ("PUT", f"/api/machines/{MACHINE}"),
        ):
            assert tablet.request(method, path, json={}).status_code == 403, path
        # Like every cookie, it is no proof that the own page has sent the request.
        del tablet.headers["X-Knifetip"]
        assert tablet.post(f"/api/machines/{MACHINE}/hands-clear").status_code == 403


def test_a_code_is_for_one_device(server: LocalClient, admin: httpx.Client) -> None:
    code = admin.post(CODES).json()["code"]
    with browser(server) as first, browser(server) as second:
        assert enter(first, code).status_code == 200
        refused = enter(second, code)
        assert refused.status_code == 401
        assert "wrong, has expired or was already used" in refused.text
        assert "set-cookie" not in refused.headers
    assert len(admin.get(DEVICES).json()) == 1


def test_an_expired_code_pairs_nothing(server: LocalClient, admin: httpx.Client) -> None:
    code = admin.post(CODES).json()["code"]
    database = server.service.store.database
    with database.writing() as session:
        row = session.scalars(sa.select(PairingCode)).one()
        assert row.expires - database.clock() == pytest.approx(CODE_LIFETIME, abs=60.0)
        assert code.replace("-", "") not in row.digest.upper()
        row.expires = database.clock() - 1.0
    with browser(server) as tablet:
        assert enter(tablet, code).status_code == 401
    assert admin.get(DEVICES).json() == []


def test_codes_cannot_be_tried_fast(
    server: LocalClient, admin: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    code = admin.post(CODES).json()["code"]
    now = [time.monotonic()]  # the test, not the speed of this computer, ends the pause
    monkeypatch.setattr(account_access, "time", SimpleNamespace(monotonic=lambda: now[0]))
    with browser(server) as stranger:
        answers = [enter(stranger, f"2222-22{n:02}") for n in range(FREE)]
        assert {answer.status_code for answer in answers} == {401}
        # Even the right code is not looked at.
        slow = enter(stranger, code)
        assert slow.status_code == 401
        assert "Too many attempts" in slow.text
        assert admin.get(DEVICES).json() == []
        now[0] += 1.0
        assert enter(stranger, code).status_code == 200


def test_a_device_is_listed_and_revoked(server: LocalClient, admin: httpx.Client) -> None:
    with paired(server, admin, "Tablet at the door") as tablet, paired(server, admin, "") as other:
        rows = {row["title"]: row["id"] for row in admin.get(DEVICES).json()}
        assert set(rows) == {"Tablet at the door", f"Device at {MACHINE}"}
        assert admin.get(f"/api/v1/machines/{OTHER}/devices").json() == []
        assert admin.get("/api/v1/machines/nothing/devices").status_code == 404
        assert admin.delete(f"/api/keys/{rows['Tablet at the door']}").status_code == 204
        assert tablet.get("/api/me").status_code == 401
        assert other.get("/api/me").status_code == 200
        # The device ends its pairing itself.
        assert other.delete("/api/session").status_code == 204
        assert admin.get(DEVICES).json() == []
    assert all(row.revoked for row in server.service.store.keys.all())


def test_the_secret_of_a_device_is_accepted_in_its_cookie_only(
    server: LocalClient, admin: httpx.Client
) -> None:
    with paired(server, admin) as tablet:
        (secret,) = [one.value or "" for one in tablet.cookies.jar]
    with browser(server, Authorization=f"Bearer {secret}") as thief:
        assert thief.get("/api/me").status_code == 401
    # The key of a program is none for a browser.
    program = server.service.store.keys.add("program", [AccessScope.STATION])[1]
    with browser(server) as page:
        page.cookies.set(f"knifetip-session-{server.base_url.port}", program)
        assert page.get("/api/me").status_code == 401


def test_a_server_with_a_key_only_pairs_devices_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 0.0)
    rules = AccessRules(key="the-key-of-the-shop")
    settings = Settings(database=f"sqlite:///{tmp_path}/a.sqlite", compiles=False)
    with (
        run_server(settings, rules) as server,
        browser(server, Authorization="Bearer the-key-of-the-shop") as admin,
        paired(server, admin) as tablet,
    ):
        assert tablet.get("/api/me").json()["kind"] == "device"


def test_without_accounts_this_computer_needs_no_pairing(server: LocalClient) -> None:
    me: dict[str, Any] = server.get("/api/me").json()
    assert me["kind"] == "local"
    assert server.post(f"/api/machines/{MACHINE}/hands-clear").status_code == 200
    with server.service.store.database.reading() as session:
        assert session.scalars(sa.select(ApiKey)).all() == []
