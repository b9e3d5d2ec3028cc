"""Access rules: requests of foreign pages, rebound names and strangers are refused."""

from __future__ import annotations

import asyncio
import time
from dataclasses import replace
from typing import Any

import httpx
import pytest
import sqlalchemy.exc
from starlette.responses import PlainTextResponse

from knifetip.messages import hint
from knifetip.service.accounts import access
from knifetip.service.accounts import sign_in as signin
from knifetip.service.accounts.access import Access, NoAccounts
from knifetip.service.accounts.access_rules import (
    AccessRules,
    Proof,
    Refusal,
    RequestFacts,
    find_access,
    parse_authority,
)
from knifetip.service.http.principal import (
    ANONYMOUS,
    EMBEDDED_GATEWAY,
    LOCAL,
    SERVER_KEY,
    Principal,
    PrincipalKind,
)
from knifetip.service.http.scopes import ALL_SCOPES, AccessScope, scopes_of_role

KEY = "correct-horse-battery"
NOW = 1_000_000.0
HOME = AccessRules(loopback_only=True)
OPEN = AccessRules()
KEYED = AccessRules(key=KEY)
OWNER = Principal(PrincipalKind.KEY, "the ERP", "k1")
#: Facts of a request: curl on this machine reads a list.
CURL = RequestFacts(
    method="GET",
    path="/api/jobs",
    scheme="http",
    host="127.0.0.1:8080",
    peer="127.0.0.1",
    server=("127.0.0.1", 8080),
    agent="curl/8.5.0",
)
RELEASE = replace(CURL, method="POST", path="/api/jobs/a/release")
#: Facts of a request: a browser on this machine, on any page.
BROWSER = replace(RELEASE, host="localhost:8080", agent="Mozilla/5.0 (X11) Chrome/130.0")
PAGE = replace(BROWSER, origins=("http://localhost:8080",), fetch_site="same-origin")
#: Facts of a request: another machine of the network.
LAN = replace(CURL, host="192.168.1.20:8080", peer="192.168.1.77", server=("192.168.1.20", 8080))


def status(rules: AccessRules, facts: RequestFacts, proof: Proof | None = None) -> int:
    """Return the HTTP status with which the rules refuse a request, 200 if they accept it."""
    found = find_access(rules, facts, NOW, proof or Proof())
    return found.status if isinstance(found, Refusal) else 200


@pytest.mark.parametrize(
    ("host", "server", "expected"),
    [
        ("localhost:8080", "127.0.0.1", 200),
        ("LOCALHOST:8080", "127.0.0.1", 200),
        ("127.0.0.1:8080", "127.0.0.1", 200),
        ("127.3.4.5:8080", "127.3.4.5", 200),
        ("[::1]:8080", "::1", 200),
        ("localhost", "127.0.0.1", 421),
        ("localhost:8081", "127.0.0.1", 421),
        ("evil.example:8080", "127.0.0.1", 421),
        ("localhost.evil.example:8080", "127.0.0.1", 421),
        ("127.0.0.1.evil.example:8080", "127.0.0.1", 421),
        ("192.0.2.10:8080", "127.0.0.1", 421),
        ("user@localhost:8080", "127.0.0.1", 421),
        ("", "127.0.0.1", 421),
        (None, "127.0.0.1", 400),
    ],
)
@pytest.mark.parametrize("facts", [CURL, RELEASE, replace(CURL, path="/"), PAGE])
def test_only_names_of_this_machine_are_answered(
    facts: RequestFacts, host: str | None, server: str, expected: int
) -> None:
    asked = replace(facts, host=host, server=(server, 8080))
    if facts is PAGE:
        asked = replace(asked, origins=(f"http://{host}",))
    assert status(HOME, asked) == expected


@pytest.mark.parametrize(
    ("allowed", "host", "expected"),
    [
        ("shop.example", "shop.example:8080", 200),
        ("shop.example", "shop.example", 200),
        ("Shop.Example", "shop.example", 200),
        ("shop.example:9000", "shop.example:9000", 200),
        ("shop.example:9000", "shop.example:8080", 421),
        ("shop.example", "other.example", 421),
        ("shop.example", "a.shop.example", 421),
        ("localhost:9000", "localhost:9000", 200),
    ],
)
def test_further_names_are_answered_where_they_are_allowed(
    allowed: str, host: str, expected: int
) -> None:
    rules = replace(HOME, hosts=(allowed,))
    assert status(rules, replace(CURL, host=host)) == expected


def test_a_default_port_may_be_left_out() -> None:
    plain = replace(CURL, host="localhost", server=("127.0.0.1", 80))
    assert status(HOME, plain) == 200
    assert status(HOME, replace(plain, scheme="https")) == 421
    page = replace(PAGE, host="localhost:80", server=("127.0.0.1", 80))
    assert status(HOME, replace(page, origins=("http://localhost",))) == 200


@pytest.mark.parametrize("method", ["POST", "PATCH", "PUT", "DELETE"])
@pytest.mark.parametrize(
    ("seen", "expected"),
    [
        ({"origins": ("http://localhost:8080",)}, 200),
        ({"origins": ("http://localhost:8080",), "fetch_site": "same-origin"}, 200),
        ({"origins": ("HTTP://LOCALHOST:8080",)}, 200),
        ({"origins": ("http://localhost:9000",), "fetch_site": "same-site"}, 403),
        ({"origins": ("http://localhost:9000",)}, 403),
        ({"origins": ("http://127.0.0.1:8080",)}, 403),
        ({"origins": ("https://localhost:8080",)}, 403),
        ({"origins": ("http://localhost",)}, 403),
        ({"origins": ("null",)}, 403),
        ({"origins": ("",)}, 403),
        ({"origins": ("http://localhost:8080", "http://evil.example")}, 403),
        ({"origins": ("http://localhost:8080.evil.example",)}, 403),
        ({"origins": ("null",), "marked": True}, 403),
        ({"origins": ("http://evil.example",), "authorization": "Bearer x"}, 403),
        ({"fetch_site": "same-site", "marked": True}, 403),
        ({"fetch_site": "cross-site"}, 403),
        ({"fetch_site": "none"}, 403),
        ({"fetch_site": "none", "agent": "curl/8.5.0"}, 200),
        ({"marked": True}, 200),
        ({"authorization": "Bearer x"}, 200),
        ({}, 403),
        ({"agent": "mozilla/4.0 (compatible; MSIE 6.0)"}, 403),
        ({"agent": None}, 403),
        ({"agent": ""}, 403),
        ({"agent": "python-httpx/0.28"}, 200),
        ({"agent": "openapi-client/1.0"}, 200),
    ],
)
def test_a_change_must_show_that_no_foreign_page_sent_it(
    method: str, seen: dict[str, Any], expected: int
) -> None:
    asked = replace(BROWSER, method=method, **seen)
    # Here "x" is the secret of an API key.
    proof = Proof(OWNER) if asked.authorization else Proof()
    assert status(HOME, asked, proof) == expected
    if not seen.get("origins"):
        # A request of a foreign page is refused even with the key; a wrong key is not accepted.
        signed_in = replace(asked, session=signin.new_session(KEY, NOW))
        # With a cookie, the name of the program is no proof either.
        shown = 401 if "authorization" in seen else expected if "marked" in seen else 403
        assert status(KEYED, signed_in) == shown


@pytest.mark.parametrize("method", ["GET", "HEAD", "OPTIONS"])
def test_reading_needs_no_such_proof(method: str) -> None:
    assert status(HOME, replace(BROWSER, method=method, fetch_site="cross-site")) == 200


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        ("application/x-www-form-urlencoded", 415),
        ("Application/X-WWW-Form-URLencoded; charset=utf-8", 415),
        ("text/plain", 415),
        ("text/plain;charset=UTF-8", 415),
        ("application/json", 200),
        ("multipart/form-data; boundary=x", 200),
        ("application/toml", 200),
        ("", 200),
    ],
)
def test_plain_forms_are_no_requests_of_the_api(kind: str, expected: int) -> None:
    for facts in (RELEASE, PAGE, replace(PAGE, marked=True)):
        assert status(HOME, replace(facts, content_type=kind)) == expected
        assert status(HOME, replace(facts, path="/sign-in", content_type=kind)) == 200


def test_without_a_key_only_this_machine_is_served() -> None:
    assert status(OPEN, CURL) == 200
    assert status(OPEN, LAN) == 403
    refused = find_access(OPEN, LAN, NOW)
    assert isinstance(refused, Refusal)
    assert "--key" in hint(refused.message)
    # A name that resolves to this machine, and another machine that sends the name localhost.
    assert status(OPEN, replace(LAN, peer="127.0.0.1", server=("127.0.0.1", 8080))) == 421
    assert status(OPEN, replace(LAN, peer="192.168.1.20")) == 403
    assert status(OPEN, replace(CURL, peer="192.168.1.77")) == 403
    assert status(OPEN, replace(CURL, peer=None)) == 403
    # An allowed host name does not replace the key, except on a server for this machine only.
    assert status(replace(OPEN, hosts=("shop",)), replace(CURL, host="shop")) == 403
    assert status(replace(HOME, hosts=("shop",)), replace(CURL, host="shop")) == 200
    assert (
        status(replace(HOME, hosts=("shop",)), replace(CURL, host="shop", peer="10.0.0.1")) == 403
    )


@pytest.mark.parametrize("peer", ["127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"])
def test_every_loopback_address_is_this_machine(peer: str) -> None:
    assert status(KEYED, replace(CURL, peer=peer)) == 200


@pytest.mark.parametrize("peer", ["172.17.0.1", "::ffff:192.168.1.7", "fe80::1", "unknown", None])
def test_others_need_the_key(peer: str | None) -> None:
    asked = replace(CURL, peer=peer)
    assert status(KEYED, asked) == 401
    assert status(KEYED, replace(asked, authorization=f"Bearer {KEY}")) == 200
    assert status(KEYED, replace(asked, authorization=f"bearer  {KEY} ")) == 200
    assert status(KEYED, replace(asked, session=signin.new_session(KEY, NOW))) == 200


@pytest.mark.parametrize(
    "header", [f"Basic {KEY}", KEY, "Bearer", "Bearer ", f"Bearer {KEY}x", f"Bearer {KEY[:-1]}"]
)
def test_a_wrong_key_gives_no_access(header: str) -> None:
    assert status(KEYED, replace(LAN, authorization=header)) == 401
    assert status(OPEN, replace(LAN, authorization=header)) == 403


def test_a_wrong_key_is_refused_on_this_machine_too() -> None:
    found = find_access(KEYED, replace(CURL, authorization="Bearer nonsense"), NOW)
    assert isinstance(found, Refusal)
    assert found.status == 401
    assert found.wrong_key


@pytest.mark.parametrize("rules", [HOME, OPEN, KEYED])
def test_a_wrong_key_is_refused_on_this_machine_also_without_any_key(rules: AccessRules) -> None:
    assert status(rules, replace(CURL, authorization="Bearer nonsense")) == 401
    assert status(rules, replace(CURL, authorization="Bearer ")) == 401


def test_the_sender_of_a_request_is_found() -> None:
    bearer = replace(CURL, authorization=f"Bearer {KEY}")
    inner = AccessRules(gateway_key="of this process")
    embedded = replace(CURL, authorization="Bearer of this process")
    cookie = replace(LAN, session=signin.new_session(KEY, NOW))
    probe = replace(LAN, path="/readyz")
    proof = Proof(OWNER, closed=True)
    for rules, facts, known, sender in (
        (HOME, CURL, Proof(), LOCAL),
        (KEYED, bearer, Proof(), SERVER_KEY),
        (KEYED, bearer, Proof(closed=True), SERVER_KEY),
        (KEYED, cookie, Proof(closed=True), SERVER_KEY),
        (inner, embedded, Proof(closed=True), EMBEDDED_GATEWAY),
        (OPEN, replace(LAN, authorization="Bearer x"), proof, OWNER),
        (OPEN, LAN, proof, OWNER),
        (OPEN, probe, Proof(closed=True), ANONYMOUS),
    ):
        assert find_access(rules, facts, NOW, known) == sender
    assert status(inner, replace(embedded, authorization="Bearer of another process")) == 401
    assert EMBEDDED_GATEWAY.scopes == {AccessScope.GATEWAY}
    assert LOCAL.scopes == ALL_SCOPES
    assert SERVER_KEY.scopes == scopes_of_role(AccessScope.ADMIN)


@pytest.mark.parametrize("rules", [HOME, OPEN, KEYED])
def test_this_machine_needs_a_key_as_well_when_an_administrator_exists(rules: AccessRules) -> None:
    assert status(rules, CURL) == 200
    for facts in (CURL, RELEASE, PAGE, LAN):
        assert status(rules, facts, Proof(closed=True)) == 401
    assert status(rules, PAGE, Proof(OWNER, closed=True)) == 200


def test_the_key_proves_intent_under_any_name_and_a_session_does_not() -> None:
    rebound = replace(LAN, host="rebound.example:8080")
    assert status(KEYED, replace(rebound, authorization=f"Bearer {KEY}")) == 200
    assert status(KEYED, replace(rebound, session=signin.new_session(KEY, NOW))) == 421
    foreign = replace(LAN, method="POST", origins=("http://evil.example",))
    assert status(KEYED, replace(foreign, authorization=f"Bearer {KEY}")) == 403


def test_probes_need_no_key() -> None:
    for path in ("/healthz", "/readyz"):
        assert status(KEYED, replace(LAN, path=path)) == 200
        assert status(OPEN, replace(LAN, path=path)) == 200
        assert status(KEYED, replace(LAN, path=path, host="rebound.example")) == 421
        assert status(KEYED, replace(LAN, path=path, method="POST")) == 401


@pytest.mark.parametrize(
    "cookie",
    [
        "",
        "x",
        ".",
        f"{int(NOW) + 100}.",
        f"{int(NOW) + 100}.{'0' * 64}",
        signin.new_session("another-key", NOW),
        signin.new_session(KEY, NOW - signin.LIFETIME - 1),
        signin.new_session(KEY, NOW).replace("1", "9", 1),
        "9" * 5000 + ".x",
        "١٢٣.x",
        "\udcff.\udcff",
    ],
)
def test_a_session_is_signed_with_the_key_and_ends(cookie: str) -> None:
    assert signin.is_session(signin.new_session(KEY, NOW), KEY, NOW)
    assert not signin.is_session(cookie, KEY, NOW)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Shop.example:80", ("shop.example", 80)),
        ("[::1]", ("::1", None)),
        ("[fe80::1]:8", ("fe80::1", 8)),
        ("::1", None),
        ("[x]", None),
        ("[::::]:1", None),
        ("a b", None),
        ("a:b", None),
        ("a/b", None),
        ("a:8080:1", None),
        ("a:123456", None),
        ("a\n", None),
    ],
)
def test_hosts_are_parsed(text: str, expected: tuple[str, int | None] | None) -> None:
    assert parse_authority(text) == expected


def client_at(rules: AccessRules, peer: str = "192.168.1.77") -> httpx.AsyncClient:
    """Return an HTTP client with address ``peer``, of an application behind the access rules.

    The application answers all requests that the rules accept.
    """
    transport = httpx.ASGITransport(
        Access(PlainTextResponse("inside"), rules), client=(peer, 40000)
    )
    return httpx.AsyncClient(transport=transport, base_url="http://192.168.1.20:8080")


HTML = {"Accept": "text/html,*/*", "User-Agent": "Mozilla/5.0"}


@pytest.fixture
def delay(monkeypatch: pytest.MonkeyPatch) -> float:
    monkeypatch.setattr(access, "WRONG_KEY_DELAY", 0.2)
    return 0.2


async def test_a_link_with_the_key_signs_a_browser_in() -> None:
    async with client_at(KEYED) as browser:
        first = await browser.get("/", headers=HTML)
        assert first.status_code == 401
        assert 'type="password"' in first.text
        answer = await browser.get(f"/?key={KEY}&a=1%26", headers=HTML)
        assert answer.status_code == 200
        cookie = answer.headers["set-cookie"].lower()
        assert "httponly" in cookie
        assert "samesite=strict" in cookie
        assert "path=/" in cookie
        assert KEY not in answer.text + answer.headers["set-cookie"]
        assert "url=/?a=1%26" in answer.text
        assert (await browser.get("/", headers=HTML)).text == "inside"
        assert (await browser.get("/api/jobs")).text == "inside"


async def test_the_key_that_is_typed_signs_a_browser_in(delay: float) -> None:
    async with client_at(KEYED) as browser:
        own = {**HTML, "Origin": "http://192.168.1.20:8080"}
        began = time.monotonic()
        wrong = await browser.post("/sign-in", data={"key": "nonsense"}, headers=own)
        assert time.monotonic() - began >= delay
        assert wrong.status_code == 401
        assert "wrong" in wrong.text
        assert "set-cookie" not in wrong.headers
        foreign = {**HTML, "Origin": "http://evil.example"}
        assert (
            await browser.post("/sign-in", data={"key": KEY}, headers=foreign)
        ).status_code == 403
        answer = await browser.post("/sign-in", data={"key": f" {KEY} "}, headers=own)
        assert "set-cookie" in answer.headers
        assert (await browser.get("/", headers=HTML)).text == "inside"


@pytest.mark.parametrize(
    "body", [b"", b"key", b"key=", b"other=1", b"key=%ff%fe", b"key=" + b"x" * 10_000, b"\xff" * 9]
)
async def test_an_invalid_key_in_the_form_is_refused(delay: float, body: bytes) -> None:
    async with client_at(KEYED) as browser:
        own = {**HTML, "Origin": "http://192.168.1.20:8080"}
        assert (await browser.post("/sign-in", content=body, headers=own)).status_code == 401


async def test_a_wrong_key_is_delayed_and_the_right_one_is_not(
    delay: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with client_at(KEYED) as client:
        wrong: tuple[dict[str, Any], ...] = (
            {"headers": {"Authorization": "Bearer x"}},
            {"params": {"key": "x"}},
        )
        for asked in wrong:
            began = time.monotonic()
            path = "/" if "params" in asked else "/api/jobs"
            assert (await client.get(path, **asked)).status_code == 401
            assert time.monotonic() - began >= delay
        right = {"Authorization": f"Bearer {KEY}"}
        monkeypatch.setattr(access, "WRONG_KEY_DELAY", 600.0)
        async with asyncio.timeout(60.0):
            assert (await client.get("/api/jobs", headers=right)).text == "inside"


async def test_a_program_without_a_key_gets_a_problem_and_no_page() -> None:
    async with client_at(KEYED) as client:
        for path, headers in (("/api/jobs", HTML), ("/", {}), ("/assets/main.js", {})):
            answer = await client.get(path, headers=headers)
            assert answer.status_code == 401
            assert answer.headers["content-type"] == "application/problem+json"
            assert answer.headers["www-authenticate"] == "Bearer"
            assert answer.json()["hint"]


async def test_after_a_link_on_another_site_the_browser_asks_once_more_with_its_cookie() -> None:
    async with client_at(KEYED) as browser:
        foreign = {**HTML, "Sec-Fetch-Site": "cross-site"}
        linked = await browser.get("/deep/?a=1", headers=foreign)
        assert 'content="0; url=/deep/?a=1&amp;again=1"' in linked.text
        # The redirect happens once only.
        assert "refresh" not in (await browser.get("/?a=1&again=1", headers=foreign)).text
        # Over plain HTTP a browser does not send the site of a link.
        assert "refresh" in (await browser.get("/", headers=HTML)).text
        for site in ("same-origin", "none"):
            own = {**HTML, "Sec-Fetch-Site": site}
            assert "refresh" not in (await browser.get("/", headers=own)).text


async def test_a_request_through_a_proxy_is_not_of_this_machine() -> None:
    async with client_at(KEYED, peer="127.0.0.1") as client:
        own = {"Host": "localhost:8080"}
        assert (await client.get("/api/jobs", headers=own)).text == "inside"
        names = ("X-Forwarded-For", "X-Forwarded-Host", "X-Forwarded-Proto", "X-Real-IP")
        for name in (*names, "Forwarded", "Via"):
            answer = await client.get("/api/jobs", headers={**own, name: "for=127.0.0.1"})
            assert answer.status_code == 401


async def test_two_hosts_in_one_request_are_refused() -> None:
    async with client_at(OPEN, peer="127.0.0.1") as client:
        hosts = [("Host", "localhost:8080"), ("Host", "evil.example")]
        assert (await client.get("/api/jobs", headers=hosts)).status_code == 400


class SilentDatabase(NoAccounts):
    """Accounts in a database that cannot be reached."""

    async def proof(self, facts: RequestFacts, *, used: bool = True) -> Proof:
        raise sqlalchemy.exc.OperationalError("SELECT", {}, Exception(facts.path))


async def test_without_the_database_only_health_probes_are_answered() -> None:
    app = Access(PlainTextResponse("inside"), HOME, SilentDatabase())
    transport = httpx.ASGITransport(app, client=("127.0.0.1", 40000))
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost:8080") as client:
        assert (await client.get("/healthz")).text == "inside"
        refused = await client.get("/api/jobs")
    assert refused.status_code == 503
    assert refused.json()["code"] == "server.database-silent"
