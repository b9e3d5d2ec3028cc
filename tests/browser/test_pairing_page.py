"""A tablet is paired with a machine by a code, and revoked."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from playwright.sync_api import Error as PlaywrightError

from tests.browser.accessibility import assert_accessible
from tests.browser.shop import Shop, add_users, open_shop, signed_in
from tests.browser.windows import open_window

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("accounts"),
    pytest.mark.timeout(600),
]

MACHINE = "demo-table"


@pytest.fixture(scope="module")
def shop(built: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shop]:
    with open_shop(tmp_path_factory.mktemp("shop")) as opened:
        add_users(opened)
        yield opened


@pytest.fixture
def tablet(browser: Browser, shop: Shop) -> Iterator[Page]:
    context = open_window(browser, viewport={"width": 820, "height": 1180}, has_touch=True)
    page = context.new_page()
    page.set_default_timeout(90_000)
    page.goto(str(shop.client.base_url))
    yield page
    context.close()


def open_devices(page: Page) -> None:
    page.evaluate("() => { location.hash = '#/machines' }")
    devices = page.get_by_test_id(f"machine-{MACHINE}").get_by_test_id("paired-devices")
    expect(devices).to_be_visible()
    devices.locator("summary").click()


def test_a_tablet_is_paired_and_revoked(
    browser: Browser, shop: Shop, tablet: Page, screenshots: Path
) -> None:
    with signed_in(browser, shop, "admin") as page:
        open_devices(page)
        card = page.get_by_test_id(f"machine-{MACHINE}")
        card.get_by_test_id("new-pairing-code").click()
        code = page.get_by_test_id("pairing-code").inner_text().strip()
        page.screenshot(path=screenshots / "pairing-code.png")
        assert len(code) == 9

        tablet.get_by_role("link", name="Pair this device with a machine").tap()
        tablet.get_by_label("Code").fill("2222-2222")
        tablet.get_by_role("button", name="Pair").tap()
        expect(tablet.get_by_role("alert")).to_contain_text(
            "wrong, has expired or was already used"
        )
        tablet.get_by_label("Code").fill(code.lower())
        tablet.get_by_label("Name of this device").fill("Tablet 7")
        assert_accessible(tablet)
        tablet.screenshot(path=screenshots / "pairing-entry.png")
        tablet.get_by_role("button", name="Pair").tap()
        expect(tablet.get_by_test_id("station-page")).to_be_visible()

        # The page judges by scopes: the station works, the order of a job does not.
        tablet.get_by_test_id("tab-machine").tap()
        expect(tablet.get_by_test_id("role-reason")).to_have_count(0)
        expect(tablet.get_by_test_id("hands-clear")).to_be_enabled()
        tablet.screenshot(path=screenshots / "pairing-station.png")
        tablet.evaluate(
            "(id) => { location.hash = id }", f"#/drawings/{shop.drawing}/jobs/{shop.job}"
        )
        expect(tablet.get_by_test_id("send")).to_be_disabled()
        reason = f"This device (Tablet 7) is paired with {MACHINE} only."
        expect(tablet.get_by_test_id("role-reason").filter(has_text=reason).first).to_be_visible()
        expect(tablet.get_by_test_id("paired-devices")).to_have_count(0)

        page.reload()
        open_devices(page)
        row = page.get_by_test_id("paired-device").filter(has_text="Tablet 7")
        expect(row).to_be_visible()
        page.screenshot(path=screenshots / "pairing-devices.png")
        page.get_by_role("button", name="Revoke Tablet 7").click()
        expect(row).to_have_count(0)
    # The page may be loading by itself, because the server refuses its key.
    with suppress(PlaywrightError):
        tablet.reload()
    expect(tablet.get_by_label("Password")).to_be_visible()


@pytest.mark.parametrize(
    "role",
    [
        pytest.param("viewer", marks=pytest.mark.long),
        pytest.param("designer", marks=pytest.mark.long),
        "operator",
    ],
)
def test_only_administrators_pair_devices(browser: Browser, shop: Shop, role: str) -> None:
    with signed_in(browser, shop, role) as page:
        page.evaluate("() => { location.hash = '#/machines' }")
        expect(page.get_by_test_id("open-station").first).to_be_visible()
        expect(page.get_by_test_id("paired-devices")).to_have_count(0)
