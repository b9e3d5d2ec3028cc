"""Signing in at a provider of OpenID Connect, which sends right and wrong tokens."""

from __future__ import annotations

import asyncio
import base64
import html
import secrets
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from joserfc import jws
from joserfc.jwk import ECKey, OctKey, RSAKey

from knifetip.errors import SettingsError, SignInRefused, WrongState
from knifetip.service.accounts.audit_store import AuditFilter
from knifetip.service.accounts.oidc import provider as oidc_provider
from knifetip.service.accounts.oidc.attempt import LIFETIME, attempt_of, new_attempt
from knifetip.service.accounts.oidc.settings import OidcSettings, read_settings
from knifetip.service.accounts.provider_users import ProviderUser
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.serving.oidc_provider import CLIENT, SECRET, OidcProvider, run_provider
from tests.support.serving.server import LocalClient, run_server

pytestmark = pytest.mark.xdist_group("oidc")

PASSWORD = "four words of text"
CALLBACK = "/sign-in/oidc/callback"
ROLES = {"shop": AccessScope.DESIGNER, "cutting": AccessScope.OPERATOR, "it": AccessScope.ADMIN}


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[OidcProvider, LocalClient]]:
    folder = tmp_path_factory.mktemp("oidc")
    with run_provider() as provider:
        (folder / "secret").write_text(SECRET)
        settings = Settings(
            database=f"sqlite:///{folder}/a.sqlite",
            compiles=False,
            page=folder,
            oidc_issuer=provider.issuer,
            oidc_client_id=CLIENT,
            oidc_client_secret_file=folder / "secret",
            oidc_role=tuple(f"{value}={role}" for value, role in ROLES.items()),
            oidc_title="<b>Shop</b>",
        )
        (folder / "index.html").write_text("the page")
        with run_server(settings) as server:
            server.service.store.users.add("root", PASSWORD, AccessScope.ADMIN)
            server.app.state.accounts.clear_cache()
            yield provider, server


@pytest.fixture
def provider(running: tuple[OidcProvider, LocalClient]) -> OidcProvider:
    one = running[0]
    fresh = OidcProvider()
    vars(one).update({**vars(fresh), "issuer": one.issuer})
    one.user["sub"] = secrets.token_hex(8)
    return one


@pytest.fixture
def server(
    running: tuple[OidcProvider, LocalClient], monkeypatch: pytest.MonkeyPatch
) -> LocalClient:
    # Each test has a provider with new keys.
    monkeypatch.setattr(oidc_provider, "_PAUSE", 0.0)
    return running[1]


@pytest.fixture
def browser(server: LocalClient) -> Iterator[httpx.Client]:
    headers = {"Accept": "text/html", "User-Agent": "Mozilla/5.0"}
    with httpx.Client(
        base_url=str(server.base_url), trust_env=False, headers=headers, timeout=60.0
    ) as one:
        yield one


def came_back(browser: httpx.Client) -> str:
    """Begin a sign-in, visit the provider, and return the URL to which it sends the browser."""
    begun = browser.get("/sign-in/oidc")
    assert begun.status_code == 302, begun.text
    sent = httpx.get(begun.headers["location"], trust_env=False, timeout=60.0)
    assert sent.status_code == 302
    return str(sent.headers["location"])


def text_of(answer: httpx.Response) -> str:
    return html.unescape(answer.text)


def assert_refused(answer: httpx.Response, *words: str) -> None:
    assert answer.status_code == 401
    for word in words:
        assert word in text_of(answer)
    assert "knifetip-session" not in answer.headers.get("set-cookie", "")
    assert "Sign in with &lt;b&gt;Shop" in answer.text


def test_a_user_signs_in_and_is_created_with_the_mapped_role(
    provider: OidcProvider, server: LocalClient, browser: httpx.Client
) -> None:
    page = browser.get("/")
    assert page.status_code == 401
    assert '<a href="/sign-in/oidc">Sign in with &lt;b&gt;Shop&lt;/b&gt;</a>' in page.text
    begun = browser.get("/sign-in/oidc")
    cookie = begun.headers["set-cookie"].lower()
    for word in ("httponly", "samesite=lax", f"path={CALLBACK}"):
        assert word in cookie
    answer = browser.get(came_back(browser))
    assert answer.status_code == 200
    assert 'content="0; url=/"' in answer.text
    cookies = ";".join(answer.headers.get_list("set-cookie")).lower()
    assert "samesite=strict" in cookies
    assert browser.get("/").text == "the page"
    me = browser.get("/api/me").json()
    assert (me["kind"], me["name"], me["sign_in"]) == ("user", "anna-example", "oidc")
    assert me["scopes"] == ["viewer", "designer", "operator", "station"]
    (row,) = [row for row in server.service.store.users.all() if row.kind == "oidc"]
    assert (row.role, row.created_by) == ("operator", provider.issuer)
    assert server.service.store.users.authenticate("anna-example", "") is None
    with pytest.raises(WrongState, match="provider"):
        server.service.store.users.change("anna-example", password="another long text")
    entry = server.service.store.audit.search(AuditFilter(action="sign_in"))[0]
    assert (entry.principal, entry.action, entry.outcome) == ("anna-example", "sign_in", "done")
    # The same user with another name and role.
    provider.user.update(preferred_username="Anna Married", roles=["shop"])
    assert browser.get(came_back(browser)).status_code == 200
    assert browser.get("/api/me").json()["scopes"] == ["viewer", "designer"]
    assert browser.get("/api/me").json()["name"] == "anna-example"
    # Disabled here, the user has no session, and gets none.
    server.service.store.users.change("anna-example", active=False)
    assert_refused(browser.get(came_back(browser)), "disabled")


def test_a_name_at_the_provider_is_not_that_of_a_user_here(
    provider: OidcProvider, browser: httpx.Client
) -> None:
    provider.user.update(sub="another", preferred_username="ROOT", roles="shop")
    assert browser.get(came_back(browser)).status_code == 200
    me = browser.get("/api/me").json()
    assert (me["name"], "admin" in me["scopes"]) == ("root-2", False)


NOW = int(time.time())


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"nonce": "another"}, "nonce"),
        ({"nonce": None}, "nonce"),
        ({"aud": "another"}, "aud"),
        ({"aud": ["another", CLIENT]}, "azp"),
        ({"aud": None}, "aud"),
        ({"iss": "https://evil.example"}, "iss"),
        ({"exp": NOW - 300}, "expired"),
        ({"exp": None}, "exp"),
        ({"sub": None}, "sub"),
    ],
)
def test_a_token_with_a_wrong_claim_is_refused(
    provider: OidcProvider,
    server: LocalClient,
    browser: httpx.Client,
    changes: dict[str, Any],
    reason: str,
) -> None:
    provider.user.update(sub="refused")
    provider.changes = changes
    before = len(server.service.store.users.all())
    assert_refused(browser.get(came_back(browser)), "token", reason)
    assert len(server.service.store.users.all()) == before
    assert browser.get("/api/me").status_code == 401


def test_a_token_that_another_key_has_signed_is_refused(
    provider: OidcProvider, browser: httpx.Client
) -> None:
    provider.key = RSAKey.generate_key(2048, {"kid": "first", "use": "sig"})
    assert_refused(browser.get(came_back(browser)), "token", "signature")


def test_a_token_that_the_client_secret_or_nobody_has_signed_is_refused(
    provider: OidcProvider, browser: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    key = OctKey.import_key(SECRET, {"kid": "first"})
    for header, sign in (({"alg": "HS256", "kid": "first"}, True), ({"alg": "none"}, False)):
        original = OidcProvider.token

        def forged(
            self: OidcProvider,
            *given: Any,
            head: dict[str, str] = header,
            signed: bool = sign,
            made: Any = original,
        ) -> dict[str, Any]:
            answer: dict[str, Any] = made(self, *given)
            claims = answer["id_token"].split(".")[1]
            if signed:
                raw = base64.urlsafe_b64decode(claims + "==")
                answer["id_token"] = jws.serialize_compact(head, raw, key, algorithms=["HS256"])
            else:
                answer["id_token"] = f"eyJhbGciOiJub25lIn0.{claims}."
            return answer

        with monkeypatch.context() as patch:
            patch.setattr(OidcProvider, "token", forged)
            assert_refused(browser.get(came_back(browser)), "token")


def test_a_new_key_of_the_provider_is_looked_up(
    provider: OidcProvider, browser: httpx.Client
) -> None:
    assert browser.get(came_back(browser)).status_code == 200
    provider.key = ECKey.generate_key("P-256", {"kid": "second", "use": "sig"})
    provider.algorithm = "ES256"
    provider.published.append(provider.key)
    assert browser.get(came_back(browser)).status_code == 200


def test_a_code_or_state_cannot_be_used_again(
    provider: OidcProvider, server: LocalClient, browser: httpx.Client
) -> None:
    # A provider that accepts codes twice, and a thief who has copied URL and cookie.
    provider.once = False
    url = came_back(browser)
    stolen = dict(browser.cookies)
    assert browser.get(url).status_code == 200
    assert_refused(browser.get(url), "already finished")
    with httpx.Client(
        base_url=str(server.base_url), trust_env=False, cookies=stolen, timeout=60.0
    ) as thief:
        assert_refused(thief.get(url), "already used")
        assert thief.get("/api/me").status_code == 401


def test_the_code_of_another_browser_or_attempt_is_refused(
    provider: OidcProvider, server: LocalClient, browser: httpx.Client
) -> None:
    with httpx.Client(base_url=str(server.base_url), trust_env=False, timeout=60.0) as attacker:
        url = came_back(attacker)
    # The victim follows the attacker's link, without and with an attempt of the own.
    assert_refused(browser.get(url), "not started")
    own = came_back(browser)
    assert_refused(browser.get(url), "not started")
    # The code of the attacker with the state of the victim: PKCE refuses it at the provider.
    own = came_back(browser)
    code = url.partition("code=")[2].partition("&")[0]
    mixed = own.replace(own.partition("code=")[2].partition("&")[0], code)
    assert_refused(browser.get(mixed), "invalid_grant")
    other = came_back(browser) + "&iss=https://evil.example"
    assert_refused(browser.get(other), "not valid: iss")


def test_a_user_without_a_role_and_a_refusal_of_the_provider(
    provider: OidcProvider, browser: httpx.Client
) -> None:
    for roles in (None, [], ["others"], {"shop": 1}, 7):
        provider.user.update(sub="visitor", roles=roles)
        assert_refused(browser.get(came_back(browser)), "no role", "--oidc-role")
    state = came_back(browser).partition("state=")[2]
    assert_refused(browser.get(f"{CALLBACK}?error=access_denied&state={state}"), "access_denied")
    state = came_back(browser).partition("state=")[2]
    answer = browser.get(f"{CALLBACK}?error=<script>&state={state}")
    assert_refused(answer, "did not sign you in")
    assert "<script>" not in answer.text


def test_a_provider_that_does_not_answer_is_named_and_asked_again_later() -> None:
    async def begin(provider: oidc_provider.Provider) -> str:
        return await provider.sign_in_url(new_attempt(time.time()), "http://localhost/")

    with run_provider() as working:
        one = oidc_provider.Provider(OidcSettings(working.issuer, CLIENT, SECRET, roles=ROLES))
        working.down = True
        for _ in range(3):
            with pytest.raises(SignInRefused, match=working.issuer):
                asyncio.run(begin(one))
        # A stranger who begins again and again sends no requests to the provider.
        assert working.requests == ["/.well-known/openid-configuration"]
        one._asked -= oidc_provider._PAUSE
        working.down = False
        assert asyncio.run(begin(one)).startswith(f"{working.issuer}/authorize?")
        # Another issuer in the metadata.
        two = oidc_provider.Provider(
            OidcSettings(working.issuer.replace("127.0.0.1", "localhost"), CLIENT, roles=ROLES)
        )
        with pytest.raises(SignInRefused, match="localhost"):
            asyncio.run(begin(two))


def test_the_cookie_of_an_attempt_ends() -> None:
    attempt = new_attempt(1000.0)
    assert attempt_of(attempt.cookie, 1000.0 + LIFETIME) == attempt
    for cookie, now in (
        (attempt.cookie, 1001.0 + LIFETIME),
        (attempt.cookie, 900.0),
        ("", 1000.0),
        ("1000." + "x" * 42, 1000.0),
        ("1000." + "ü" * 43, 1000.0),
        ("x." + "x" * 43, 1000.0),
    ):
        assert attempt_of(cookie, now) is None
    texts = {attempt.state, attempt.nonce, attempt.verifier, attempt.digest, attempt.cookie}
    assert len(texts) == 5
    assert len(attempt.verifier) == 43


def test_settings_are_checked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    secret = tmp_path / "secret"
    secret.write_text("s3cret\n")
    read = read_settings("https://id.example/realm", "c", secret_file=secret, roles=["a=b=viewer"])
    assert read is not None
    assert (read.title, read.client_secret, dict(read.roles)) == (
        "id.example",
        "s3cret",
        {"a=b": "viewer"},
    )
    assert "s3cret" not in repr(read)
    assert read_settings("", "") is None
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"issuer": ""}, "oidc.no-issuer"),
        ({"issuer": "http://id.example"}, "oidc.bad-url"),
        ({"public_url": "ftp://x"}, "oidc.bad-url"),
        ({"client_id": ""}, "oidc.no-client"),
        ({"roles": []}, "oidc.no-roles"),
        ({"roles": ["shop"]}, "oidc.bad-role"),
        ({"roles": ["shop=gateway"]}, "oidc.bad-role"),
        ({"secret_file": tmp_path / "none"}, "settings.key-file"),
    ]
    right: dict[str, Any] = {
        "issuer": "https://id.example",
        "client_id": "c",
        "roles": ["a=viewer"],
    }
    for change, code in wrong:
        with pytest.raises(SettingsError) as refused:
            read_settings(**{**right, **change})
        assert refused.value.message.code == code
        assert refused.value.hint
    monkeypatch.setattr("importlib.util.find_spec", lambda _name: None)
    with pytest.raises(SettingsError, match="not installed") as refused:
        read_settings(**right)
    assert "knifetip[oidc]" in refused.value.hint


def test_authlib_is_loaded_for_a_provider_only() -> None:
    code = "import sys, knifetip.server.app as a; a.create_app(); print('authlib' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_users_of_a_provider_in_both_databases(database_url: str) -> None:
    store = Store(database_url)
    store.migrate()
    admin = ProviderUser("https://a", "1", "Ünal, Öz\u202e", AccessScope.ADMIN, "first")
    made = store.provider_users.record_sign_in(admin)
    assert (made.name, made.kind, made.role) == ("nal-z-", "oidc", "admin")
    with pytest.raises(SignInRefused, match="already"):
        store.provider_users.record_sign_in(admin)
    token = store.sessions.open(made)
    demoted = ProviderUser("https://a", "1", "x", AccessScope.VIEWER, "second")
    with pytest.raises(WrongState, match="last active"):
        store.provider_users.record_sign_in(demoted)
    assert store.sessions.find(token) is not None
    other = ProviderUser("https://b", "1", "nal-z-", AccessScope.ADMIN, "third")
    assert store.provider_users.record_sign_in(other).name == "nal-z--2"
    assert store.provider_users.record_sign_in(demoted).role == "viewer"
    assert store.sessions.find(token) is None
    store.close()
