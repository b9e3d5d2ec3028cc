"""Signing in, users, keys and the audit log through the API of a real server."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.errors import SignInRefused, SignInSlowDown
from knifetip.service.accounts import access
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.accounts.account_access import KEPT, Accounts
from knifetip.service.accounts.audit_store import AuditFilter
from knifetip.service.accounts.sign_in_throttle import FORGOTTEN, FREE, LONGEST, SignInThrottle
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from tests.support.serving.server import LocalClient, run_server, square, upload_drawing

ADMIN = {"name": "anna", "password": "four words of text", "role": "admin"}
CAROL = {"name": "carol", "password": "carol draws cartons", "role": "designer"}


@pytest.fixture
def server(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[LocalClient]:
    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 0.0)
    settings = Settings(database=f"sqlite:///{tmp_path}/a.sqlite", compiles=False, page=tmp_path)
    with run_server(settings) as client:
        yield client


@pytest.fixture
def admin(server: LocalClient) -> Iterator[httpx.Client]:
    """Return a client with the session of the first administrator."""
    assert server.post("/api/users", json=ADMIN).status_code == 201
    with visitor(server) as client:
        sign_in(client, ADMIN)
        yield client


def visitor(server: httpx.Client, key: str = "") -> httpx.Client:
    headers = {"X-Knifetip": "test", **({"Authorization": f"Bearer {key}"} if key else {})}
    return httpx.Client(base_url=server.base_url, trust_env=False, timeout=300.0, headers=headers)


def sign_in(client: httpx.Client, user: dict[str, str]) -> httpx.Response:
    sent = {"name": user["name"], "password": user["password"]}
    answer = client.post("/api/session", json=sent)
    assert answer.status_code == 200, answer.text
    return answer


def new_key(admin: httpx.Client, *scopes: str) -> dict[str, Any]:
    answer = admin.post("/api/keys", json={"title": "ERP", "scopes": scopes})
    assert answer.status_code == 201, answer.text
    made: dict[str, Any] = answer.json()
    return made


def test_the_first_administrator_closes_this_computer_to_others(server: LocalClient) -> None:
    me = server.get("/api/me").json()
    assert (me["kind"], me["has_admin"]) == ("local", False)
    assert set(me["scopes"]) == set(AccessScope)
    assert server.get("/api/jobs").status_code == 200
    made = server.post("/api/users", json=ADMIN)
    assert made.status_code == 201
    assert "password" not in made.json()
    assert ADMIN["password"] not in made.text
    assert "$argon2" not in made.text
    for path in ("/api/jobs", "/api/me", "/api/users", "/api/openapi.json"):
        assert server.get(path).status_code == 401, path
    assert server.get("/healthz").status_code == 200
    assert server.post("/api/users", json=CAROL).status_code == 401
    answer = sign_in(server, ADMIN)
    cookie = answer.headers["set-cookie"].lower()
    for word in ("httponly", "samesite=strict", "path=/"):
        assert word in cookie
    me = server.get("/api/me").json()
    assert (me["kind"], me["name"], me["has_admin"]) == ("user", "anna", True)
    assert set(me["scopes"]) == {"viewer", "designer", "operator", "admin", "station"}
    assert server.delete("/api/session").status_code == 403  # the cookie alone is no proof
    assert server.delete("/api/session", headers={"X-Knifetip": "test"}).status_code == 204
    assert server.get("/api/jobs").status_code == 401


def test_an_administrator_of_another_process_closes_it_soon(server: LocalClient) -> None:
    assert server.get("/api/jobs").status_code == 200
    # As the command line does: this server is not notified.
    server.service.store.users.add("anna", ADMIN["password"], AccessScope.ADMIN)
    deadline = time.monotonic() + KEPT + 60.0
    while server.get("/api/jobs").status_code == 200:
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_a_role_permits_what_it_contains(server: LocalClient, admin: httpx.Client) -> None:
    assert admin.post("/api/users", json=CAROL).status_code == 201
    with visitor(server) as carol:
        sign_in(carol, CAROL)
        drawing = upload_drawing(carol, square())["id"]
        refused = carol.post("/api/jobs/none/release")
        assert refused.status_code == 403
        assert "operator" in refused.json()["detail"]
        assert refused.json()["code"] == "request.scope-missing"
        assert carol.get("/api/users").status_code == 403
        # A queued job is the operator's decision.
        order = {"drawing": drawing, "machine": "demo-table", "board": "e-flute"}
        assert carol.post("/api/jobs", json={**order, "release": True}).status_code == 403
        assert carol.post("/api/jobs", json=order).status_code == 201
        answer = carol.post("/api/gateway/claim", json={"gateway": "g", "machine": "demo-table"})
        assert answer.status_code == 403
        assert "gateway" in answer.json()["detail"]


def test_a_designer_cancels_own_jobs_until_they_are_queued(
    server: LocalClient, admin: httpx.Client
) -> None:
    admin.post("/api/users", json=CAROL)
    with visitor(server) as carol:
        sign_in(carol, CAROL)
        drawing = upload_drawing(carol, square())["id"]
        order = {"drawing": drawing, "machine": "demo-table", "board": "e-flute"}
        own = carol.post("/api/jobs", json=order).json()["id"]
        other = admin.post("/api/jobs", json=order).json()["id"]
        assert carol.post(f"/api/jobs/{other}/cancel").status_code == 403
        assert carol.post(f"/api/jobs/{own}/cancel").status_code == 200
        assert [event["who"] for event in carol.get(f"/api/jobs/{own}/events").json()] == [
            "operator carol",
            "operator carol",
        ]
        assert admin.post(f"/api/jobs/{other}/cancel").status_code == 200


def test_a_change_of_a_user_ends_the_sessions(server: LocalClient, admin: httpx.Client) -> None:
    admin.post("/api/users", json=CAROL)
    for change, code in (
        ({"role": "viewer"}, 200),
        ({"password": "another long text"}, 200),
        ({"active": False}, 401),
    ):
        with visitor(server) as carol:
            user = {**CAROL, **({} if "role" in change else {"password": "another long text"})}
            user = CAROL if "role" in change or "password" in change else user
            sign_in(carol, user)
            assert carol.get("/api/me").status_code == 200
            assert admin.patch("/api/users/carol", json=change).status_code == 200
            assert carol.get("/api/me").status_code == 401
            sent = {"name": "carol", "password": {**CAROL, **change}["password"]}
            if "active" in change:
                sent["password"] = "another long text"
            assert carol.post("/api/session", json=sent).status_code == code
    assert admin.patch("/api/users/anna", json={"active": False}).status_code == 409
    assert admin.get("/api/me").status_code == 200


def test_a_user_changes_the_own_password(server: LocalClient, admin: httpx.Client) -> None:
    admin.post("/api/users", json=CAROL)
    with visitor(server) as carol, visitor(server) as tablet:
        sign_in(carol, CAROL)
        sign_in(tablet, CAROL)
        body = {"current": "not the password", "new": "a new long password"}
        assert carol.post("/api/me/password", json=body).status_code == 422
        body["current"] = CAROL["password"]
        assert carol.post("/api/me/password", json={**body, "new": "short"}).status_code == 422
        session = dict(carol.cookies)
        assert carol.post("/api/me/password", json=body).status_code == 204
        # Requests that were sent before the answer arrives have the cookie of the same session.
        assert dict(carol.cookies) == session
        assert carol.get("/api/me").status_code == 200
        assert tablet.get("/api/me").status_code == 401


def test_a_key_is_shown_once_and_can_be_revoked(server: LocalClient, admin: httpx.Client) -> None:
    made = new_key(admin, "designer")
    listed = admin.get("/api/keys")
    assert made["secret"] not in listed.text
    assert [(row["id"], row["scopes"], row["created_by"]) for row in listed.json()] == [
        (made["id"], ["designer"], "anna")
    ]
    with visitor(server, made["secret"]) as program, visitor(server, made["secret"] + "x") as wrong:
        assert program.get("/api/me").json()["scopes"] == ["viewer", "designer"]
        assert program.get("/api/users").status_code == 403
        assert wrong.get("/api/me").status_code == 401
        assert admin.delete(f"/api/keys/{made['id']}").status_code == 204
        assert program.get("/api/me").status_code == 401
    assert admin.get("/api/keys").json()[0]["revoked"]


def test_a_page_of_another_site_cannot_use_a_session(
    server: LocalClient, admin: httpx.Client
) -> None:
    browser = {"User-Agent": "Mozilla/5.0"}
    del admin.headers["X-Knifetip"]
    for headers, status in (
        ({"Origin": "http://evil.example"}, 403),
        ({"Origin": str(server.base_url).rstrip("/").replace("127.0.0.1", "localhost")}, 403),
        ({}, 403),
        ({"Origin": str(server.base_url).rstrip("/")}, 201),
    ):
        answer = admin.post("/api/users", json=CAROL, headers={**browser, **headers})
        assert answer.status_code == status, headers


def test_each_change_and_each_refusal_is_in_the_audit_log(
    server: LocalClient, admin: httpx.Client
) -> None:
    admin.post("/api/users", json=CAROL)
    admin.post("/api/users", json=CAROL)
    with visitor(server) as carol:
        sign_in(carol, CAROL)
        drawing = upload_drawing(carol, square())["id"]
        carol.get("/api/users")
        carol.delete("/api/keys/none")
        wrong = {"name": "carol", "password": "wrong wrong wrong"}
        assert carol.post("/api/session", json=wrong).status_code == 401
        wrong["name"] = "my-secret-password"
        assert carol.post("/api/session", json=wrong).status_code == 401
    answer = admin.get("/api/audit")
    found = [
        (row["principal"], row["action"], row["subject_kind"], row["subject"], row["outcome"])
        for row in answer.json()
    ]
    assert found == [
        ("", "sign_in", "user", "", "refused"),
        ("carol", "sign_in", "user", "carol", "refused"),
        ("carol", "revoke_key", "key", "none", "refused"),
        ("carol", "upload_drawing", "drawing", drawing, "done"),
        ("carol", "sign_in", "user", "carol", "done"),
        ("anna", "create_user", "user", "carol", "refused"),
        ("anna", "create_user", "user", "carol", "done"),
        ("anna", "sign_in", "user", "anna", "done"),
        ("local", "create_user", "user", "anna", "done"),
    ]
    assert {row["peer"] for row in answer.json()} == {"127.0.0.1"}
    first = admin.get("/api/audit?outcome=done&limit=2")
    assert [row["action"] for row in first.json()] == ["upload_drawing", "sign_in"]
    following = first.links["next"]["url"]
    assert [row["action"] for row in admin.get(following).json()] == ["create_user", "sign_in"]


def test_failed_sign_ins_are_slowed_down(server: LocalClient, admin: httpx.Client) -> None:
    wrong = {"name": "anna", "password": "wrong wrong wrong"}
    answers = [server.post("/api/session", json=wrong) for _ in range(FREE + 1)]
    assert [answer.status_code for answer in answers] == [401] * FREE + [429]
    assert int(answers[-1].headers["Retry-After"]) >= 1
    assert admin.get("/api/me").status_code == 200


def test_the_pause_grows_for_one_account_at_one_address_only() -> None:
    throttle, now = SignInThrottle(), 100.0
    pauses = []
    for _ in range(FREE + 6):
        throttle.failed("anna", "a", now)
        pauses.append(throttle.pause("anna", "a", now))
        now += pauses[-1]
        assert throttle.pause("anna", "a", now) == 0
    assert pauses == [0] * (FREE - 1) + [1, 2, 4, 8, 15, 15, 15]
    assert LONGEST == 15.0
    throttle.failed("anna", "a", now)
    assert throttle.pause("anna", "b", now) == throttle.pause("bob", "a", now) == 0
    assert throttle.pause("anna", "a", now + FORGOTTEN + 1.0) == 0
    throttle.succeeded("anna", "a")
    assert throttle.pause("anna", "a", now) == 0


def test_addresses_of_one_network_of_ipv6_share_their_failed_sign_ins(server: LocalClient) -> None:
    store = server.service.store
    store.users.add("anna", ADMIN["password"], AccessScope.ADMIN)
    accounts = Accounts()
    accounts.store = store

    async def attempts() -> list[type[Exception]]:
        refusals: list[type[Exception]] = []
        for number in range(FREE + 1):
            with pytest.raises((SignInRefused, SignInSlowDown)) as refused:
                await accounts.sign_in("anna", "wrong wrong wrong", f"2001:db8::{number:x}")
            refusals.append(refused.type)
        token = await accounts.sign_in("anna", ADMIN["password"], "2001:db8:0:1::1")
        assert (await accounts.user_of(token)).name == "anna"
        return refusals

    assert asyncio.run(attempts()) == [SignInRefused] * FREE + [SignInSlowDown]
    accounts.close()


@pytest.mark.parametrize("media", ["application/json", "multipart/form-data; boundary=x"])
def test_a_stranger_cannot_send_a_large_body(
    server: LocalClient, admin: httpx.Client, media: str
) -> None:
    content, headers = b"x" * (2 << 20), {"Content-Type": media}
    with visitor(server) as stranger:
        answer = stranger.post("/api/session", content=content, headers=headers)
    assert answer.status_code == 413
    assert answer.json()["code"] == "request.body-too-large"
    assert "1 MB" in answer.json()["detail"]
    # The limit of a user is another.
    answer = admin.post("/api/me/password", content=content, headers=headers)
    assert answer.status_code == (422 if media.endswith("json") else 415)


def test_a_stranger_writes_nothing_into_the_audit_log(
    server: LocalClient, admin: httpx.Client
) -> None:
    with visitor(server) as stranger:
        stranger.cookies.set(f"knifetip-session-{server.base_url.port}", "no session")
        for _ in range(3):
            assert stranger.delete("/api/session").status_code == 204
    assert "sign_out" not in [row["action"] for row in admin.get("/api/audit").json()]
    assert admin.delete("/api/session").status_code == 204
    newest = server.service.store.audit.search(AuditFilter())[0]
    assert (newest.principal, newest.action, newest.outcome) == ("anna", "sign_out", "done")


def test_a_refusal_in_a_response_with_status_200_is_refused_in_the_audit_log(
    server: LocalClient, admin: httpx.Client
) -> None:
    drawing = upload_drawing(admin, square())["id"]
    order = {"drawing": drawing, "machine": "demo-table", "board": "e-flute"}
    job = admin.post("/api/jobs", json=order).json()["id"]
    hold = (
        '<XJMF xmlns="http://www.CIP4.org/JDFSchema_2_0">'
        '<Header DeviceID="ERP" Time="2026-01-02T03:04:05+01:00"/><CommandModifyQueueEntry>'
        '<Header ID="M1" DeviceID="ERP" Time="2026-01-02T03:04:05+01:00"/>'
        '<ModifyQueueEntryParams Operation="Hold">'
        f'<QueueFilter QueueEntryIDs="{job}"/></ModifyQueueEntryParams>'
        "</CommandModifyQueueEntry></XJMF>"
    )
    headers = {"Content-Type": "application/vnd.cip4-xjmf+xml"}
    with visitor(server, new_key(admin, "designer")["secret"]) as erp:
        answer = erp.post("/api/xjmf", content=hold, headers=headers)
        assert answer.status_code == 200, answer.text
        assert 'ReturnCode="0"' not in answer.text
        unknown = {"orders": [{**order, "drawing": "none"}]}
        assert erp.post("/api/orders/batch", json=unknown).json()[0]["problem"]
        assert erp.post("/api/orders/batch", json={"orders": [order]}).json()[0]["job"]
    rows = admin.get("/api/audit?principal=ERP").json()
    assert [(row["action"], row["outcome"]) for row in rows] == [
        ("place_orders", "done"),
        ("place_orders", "refused"),
        ("answer_xjmf", "refused"),
    ]


def test_behind_a_tls_proxy_the_page_can_sign_in_and_its_cookie_is_secure(
    server: LocalClient, admin: httpx.Client
) -> None:
    sent = {"name": ADMIN["name"], "password": ADMIN["password"]}
    host = f"localhost:{server.base_url.port}"
    proxied = {"Host": host, "X-Forwarded-For": "192.0.2.7", "X-Forwarded-Proto": "https"}
    with httpx.Client(base_url=server.base_url, trust_env=False, timeout=300.0) as page:
        own = {**proxied, "Origin": f"https://{host}", "User-Agent": "Mozilla/5.0"}
        answer = page.post("/api/session", json=sent, headers=own)
        assert answer.status_code == 200, answer.text
        assert "; Secure" in answer.headers["Set-Cookie"]
        insecure = page.post("/api/session", json=sent, headers={**own, "Origin": f"http://{host}"})
        assert insecure.status_code == 403
    newest = admin.get("/api/audit?action=sign_in&limit=1").json()
    assert newest[0]["peer"] == "192.0.2.7"


def test_a_sign_in_with_the_key_of_the_server_is_in_the_audit_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 0.0)
    key = "correct-horse-battery"
    settings = Settings(database=f"sqlite:///{tmp_path}/a.sqlite", compiles=False)
    with run_server(settings, AccessRules(key=key)) as server, visitor(server) as browser:
        assert browser.get("/?key=wrong-horse-battery").status_code == 401
        assert browser.post("/sign-in", data={"key": key}).status_code == 200
        assert browser.get(f"/?key={key}").status_code == 200
        rows = browser.get("/api/audit").json()
    assert [(row["kind"], row["action"], row["outcome"], row["peer"]) for row in rows] == [
        ("server-key", "sign_in", "done", "127.0.0.1")
    ] * 2
