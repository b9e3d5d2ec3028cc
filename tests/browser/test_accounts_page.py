"""What each role can do on the page, and the account dialog: password, sign-out, users and keys."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
import sqlalchemy as sa
from playwright.sync_api import Browser, FilePayload, Page, expect

from knifetip.service.database.account_tables import UserAccount
from knifetip.service.http.scopes import ROLES, AccessScope
from tests.browser.shop import PASSWORD, Shop, add_users, open_shop, signed_in
from tests.browser.steps import go_to
from tests.support.hostile_names import HOSTILE_NAMES, acting
from tests.support.serving.server import square

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("accounts"),
    pytest.mark.timeout(600),
]


@pytest.fixture(scope="module")
def shop(built: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shop]:
    with open_shop(tmp_path_factory.mktemp("shop")) as opened:
        add_users(opened)
        yield opened


# What the other roles can do in each view: test_roles_page.py.
@pytest.mark.long
@pytest.mark.parametrize("role", ROLES)
def test_a_role_can_use_its_controls_only(
    browser: Browser, shop: Shop, screenshots: Path, role: AccessScope
) -> None:
    rank = ROLES.index(role)
    designs, operates = rank >= 1, rank >= 2
    with signed_in(browser, shop, role.value) as page:
        page.evaluate(
            "(id) => { location.hash = id }", f"#/drawings/{shop.drawing}/jobs/{shop.job}"
        )
        send = page.get_by_test_id("send")
        expect(send).to_be_visible()
        if operates:
            expect(send).to_be_enabled()
            expect(page.get_by_test_id("role-reason")).to_have_count(0)
        else:
            expect(send).to_be_disabled()
            reason = "Only operators and administrators can do this."
            expect(send).to_have_attribute(
                "title", f"{reason} You are signed in as {role} ({role})."
            )
            expect(page.get_by_test_id("role-reason").filter(has_text=reason)).to_be_visible()
        expect(page.get_by_test_id("cancel")).to_be_enabled(enabled=designs)
        go_to(page, "sheet")
        for name in ("copies", "machine-select"):
            expect(page.get_by_test_id(name)).to_be_enabled(enabled=designs)
        for width, height in ((1440, 900), (1024, 768), (820, 1180), (390, 844)):
            page.set_viewport_size({"width": width, "height": height})
            page.screenshot(path=screenshots / f"role-{role}-{width}.png")
        page.set_viewport_size({"width": 1440, "height": 900})
        page.evaluate("() => { location.hash = '#/' }")
        expect(page.get_by_test_id("choose-file")).to_be_enabled(enabled=designs)
        page.screenshot(path=screenshots / f"role-{role}-drawings.png")
        if designs:
            file = FilePayload(
                name=f"{role}.dxf", mimeType="image/vnd.dxf", buffer=square(side=77.0 + rank)
            )
            page.get_by_test_id("file-input").set_input_files(file)
            expect(page.get_by_role("heading", name=f"{role}.dxf")).to_be_visible()


def test_the_page_of_a_machine_is_for_looking_only_without_the_role(
    browser: Browser, shop: Shop, screenshots: Path
) -> None:
    with signed_in(browser, shop, "designer") as page:
        page.evaluate("() => { location.hash = '#/station/demo-table' }")
        expect(page.get_by_test_id("station-page")).to_be_visible()
        for name in ("station-hold", "station-stop"):
            expect(page.get_by_test_id(name)).to_be_disabled()
        expect(page.get_by_test_id("role-reason").first).to_contain_text("Only operators")
        page.screenshot(path=screenshots / "role-designer-station.png")


def test_a_user_changes_the_password_and_signs_out(browser: Browser, shop: Shop) -> None:
    shop.store.users.add("carol", PASSWORD, AccessScope.DESIGNER)
    with signed_in(browser, shop, "carol") as page:
        page.get_by_test_id("account").click()
        expect(page.get_by_test_id("account-name")).to_contain_text("carol (designer)")
        for name in ("users", "keys", "audit"):
            expect(page.get_by_test_id(name)).to_have_count(0)
        form = page.get_by_role("form", name="Change the password")
        form.get_by_label("Current password").fill("not the password")
        form.get_by_label("New password").fill("another long text")
        form.get_by_role("button", name="Change the password").click()
        expect(form.get_by_role("alert")).to_contain_text("The current password is wrong.")
        form.get_by_label("Current password").fill(PASSWORD)
        form.get_by_label("New password").fill("another long text")
        form.get_by_role("button", name="Change the password").click()
        expect(form.get_by_role("status")).to_contain_text("Password changed.")
        page.get_by_test_id("sign-out").click()
        expect(page.get_by_role("button", name="Sign in")).to_be_visible()
        assert not [one for one in page.context.cookies() if "session" in one["name"]]
    assert shop.store.users.authenticate("carol", PASSWORD) is None
    with signed_in(browser, shop, "carol", "another long text") as page:
        # A user of a provider has no password here.
        with shop.store.database.writing() as session:
            session.execute(
                sa.update(UserAccount).where(UserAccount.name == "carol").values(kind="oidc")
            )
        page.reload()
        page.get_by_test_id("account").click()
        expect(page.get_by_text("managed by the provider")).to_be_visible()
        expect(page.get_by_role("form", name="Change the password")).to_have_count(0)
        page.keyboard.press("Escape")
        # The stream of events tells the page that its session has ended.
        shop.store.users.change("carol", active=False)
        expect(page.get_by_role("button", name="Sign in")).to_be_visible()


def test_an_administrator_manages_users_and_keys(
    browser: Browser, shop: Shop, screenshots: Path
) -> None:
    with signed_in(browser, shop, "admin") as page:
        page.get_by_test_id("account").click()
        page.get_by_role("tab", name="Users").click()
        users = page.get_by_test_id("users")
        users.get_by_label("Name").fill("dora")
        users.get_by_label("Password").first.fill(PASSWORD)
        users.get_by_role("button", name="Create a user").click()
        expect(users.get_by_role("status")).to_contain_text("User dora created.")
        page.get_by_role("tab", name="API keys").click()
        keys = page.get_by_test_id("keys")
        keys.get_by_label("Title of the key").fill("ERP <b>")
        keys.get_by_role("button", name="Create a key").click()
        secret = page.get_by_test_id("key-secret").inner_text().strip()
        page.screenshot(path=screenshots / "account-keys.png")
        with httpx.Client(base_url=shop.client.base_url, trust_env=False) as program:
            program.headers["Authorization"] = f"Bearer {secret}"
            assert program.get("/api/me").json()["scopes"] == ["viewer", "order"]
            row = keys.locator("li").filter(has_text="ERP <b>")
            row.get_by_role("button", name="Revoke").click()
            expect(row).to_contain_text("revoked")
            assert program.get("/api/me").status_code == 401
    user = shop.store.users.authenticate("dora", PASSWORD)
    assert user is not None
    assert user.role == "designer"


def test_hostile_titles_of_keys_and_webhooks_are_text(
    browser: Browser, shop: Shop, screenshots: Path
) -> None:
    with signed_in(browser, shop, "admin") as page:
        session = {one["name"]: one["value"] for one in page.context.cookies()}
        with httpx.Client(
            base_url=shop.client.base_url,
            trust_env=False,
            cookies=session,
            headers={"X-Knifetip": "test"},
        ) as admin:

            def send(path: str, **fields: object) -> int:
                # Escapes, since UTF-8 has no lone surrogates.
                return admin.post(
                    path,
                    content=json.dumps(fields),
                    headers={"Content-Type": "application/json"},
                ).status_code

            for position, name in enumerate([*HOSTILE_NAMES.values(), 100 * "W"]):
                url = f"http://127.0.0.1:9/{position}"
                # A name is stored or refused, and never an error of the server.
                assert send("/api/keys", title=name[:100], scopes=["viewer"]) in (201, 422), name
                assert send("/api/webhooks", url=url, description=name) in (201, 422, 409), name
            assert send("/api/keys", title=10_000 * "x", scopes=["viewer"]) == 422
            assert send("/api/users", name=10_000 * "x", password=PASSWORD, role="viewer") == 422
            made = len(admin.get("/api/keys").json())
        page.get_by_test_id("account").click()
        page.get_by_role("tab", name="API keys").click()
        expect(page.get_by_test_id("keys").locator("li")).to_have_count(made)
        assert_harmless(page)
        text = page.get_by_test_id("keys").inner_text()
        assert acting(text, permitted="\n\t") == set()
        page.screenshot(path=screenshots / "hostile-keys.png")
        page.goto(f"{shop.client.base_url}/#/webhooks")
        page.reload()
        expect(page.get_by_text("http://127.0.0.1:9/0").first).to_be_visible()
        assert_harmless(page)
        page.screenshot(path=screenshots / "hostile-webhooks.png")


def assert_harmless(page: Page) -> None:
    assert page.evaluate("window.hacked") is None
    assert page.locator("img[src=x]").count() == 0
    # Nothing is wider than the window because of a long name.
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")


@pytest.mark.long
def test_the_owner_of_a_drawing_shares_it(browser: Browser, shop: Shop, screenshots: Path) -> None:
    with signed_in(browser, shop, "designer") as page:
        file = FilePayload(name="own.dxf", mimeType="image/vnd.dxf", buffer=square(side=91.0))
        page.get_by_test_id("file-input").set_input_files(file)
        expect(page.get_by_role("heading", name="own.dxf")).to_be_visible()
        drawing = page.url.partition("#")[2].split("/")[2]
        go_to(page, "lines")
        place = page.url.partition("#")[2]
        box = page.get_by_test_id("share-drawing")
        expect(box).not_to_be_checked()
        page.screenshot(path=screenshots / "share-drawing.png")
        box.click()  # its state is that of the server, after the answer
        expect(box).to_be_checked()
        page.reload()
        expect(box).to_be_checked()
        assert shop.store.drawings.get(drawing).shared
    with signed_in(browser, shop, "viewer") as page:
        page.evaluate("(hash) => { location.hash = hash }", place)
        expect(page.get_by_test_id("share-drawing")).to_be_disabled()
    with signed_in(browser, shop, "operator") as page:
        page.evaluate("(hash) => { location.hash = hash }", place)
        page.get_by_test_id("share-drawing").click()
        expect(page.get_by_test_id("share-drawing")).not_to_be_checked()
        page.reload()
        expect(page.get_by_test_id("share-drawing")).not_to_be_checked()
        assert not shop.store.drawings.get(drawing).shared
