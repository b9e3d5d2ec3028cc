"""Signing in, users, keys and the audit log through the API of a real server."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.api import access
from knifetip.api.account_access import KEPT
from knifetip.api.service import Settings
from knifetip.api.slow_down import FORGOTTEN, FREE, LONGEST, SlowDown
from knifetip.jobs.accounts.scopes import AccessScope
from tests.support.serving.server import LocalClient, run_server, square, upload_drawing

ADMIN = {"name": "anna", "password": "four words of text", "role": "admin"}
CAROL = {"name": "carol", "password": "carol draws cartons", "role": "designer"}


@pytest.fixture
def server(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[LocalClient]:
    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 0.0)
    settings = Settings(f"sqlite:///{tmp_path}/a.sqlite", compiles=False, page=tmp_path)
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
    return httpx.Client(base_url=server.base_url, trust_env=False, timeout=30.0, headers=headers)


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
    assert set(me["scopes"]) == {"viewer", "designer", "operator", "admin"}
    assert server.delete("/api/session").status_code == 204
    assert server.get("/api/jobs").status_code == 401


def test_an_administrator_of_another_process_closes_it_soon(server: LocalClient) -> None:
    assert server.get("/api/jobs").status_code == 200
    # As the command line does: this server is not notified.
    server.service.store.users.add("anna", ADMIN["password"], AccessScope.ADMIN)
    deadline = time.monotonic() + KEPT + 10.0
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
    slow, now = SlowDown(), 100.0
    pauses = []
    for _ in range(FREE + 6):
        slow.failed("anna", "a", now)
        pauses.append(slow.pause("anna", "a", now))
        now += pauses[-1]
        assert slow.pause("anna", "a", now) == 0
    assert pauses == [0] * (FREE - 1) + [1, 2, 4, 8, 15, 15, 15]
    assert LONGEST == 15.0
    slow.failed("anna", "a", now)
    assert slow.pause("anna", "b", now) == slow.pause("bob", "a", now) == 0
    assert slow.pause("anna", "a", now + FORGOTTEN + 1.0) == 0
    slow.succeeded("anna", "a")
    assert slow.pause("anna", "a", now) == 0
