"""Addresses of the page: tabs of the library, history, machines and settings, and unknown ones."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import Running

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


def test_every_shelf_has_an_address_and_the_history_of_the_browser(
    page: Page, server: Running
) -> None:
    page.goto(f"{server.url}/#/library")
    list_of = page.get_by_test_id("library").get_by_role("navigation")
    for shelf, entry, other in (
        ("machines", "demo-table", "greyboard-1.5"),
        ("boards", "greyboard-1.5", "demo-table"),
        ("tools", "v-cutter-45", "greyboard-1.5"),
    ):
        page.get_by_test_id(f"shelf-{shelf}").click()
        expect(page).to_have_url(f"{server.url}/#/library/{shelf}")
        expect(page.get_by_test_id("not-found")).to_have_count(0)
        expect(list_of.get_by_test_id(f"entry-{entry}")).to_be_visible()
        expect(list_of.get_by_test_id(f"entry-{other}")).to_have_count(0)
    page.go_back()
    expect(page.get_by_test_id("shelf-boards")).to_have_attribute("aria-current", "page")
    page.go_forward()
    expect(page.get_by_test_id("shelf-tools")).to_have_attribute("aria-current", "page")
    # The structure of the page has no way back to drawings but the rail.
    expect(page.get_by_text("Back to drawings")).to_have_count(0)


def test_views_of_the_history_and_single_machines_have_addresses(
    page: Page, server: Running
) -> None:
    page.goto(f"{server.url}/#/history")
    page.get_by_text("Statistics", exact=True).click()
    expect(page).to_have_url(f"{server.url}/#/history/statistics")
    page.go_back()
    expect(page.get_by_role("radio", name="Ended jobs")).to_be_checked()
    page.go_forward()
    expect(page.get_by_role("radio", name="Statistics")).to_be_checked()
    page.goto(f"{server.url}/#/machines")
    page.get_by_test_id("machine-demo-table").get_by_test_id("only-machine").click()
    expect(page).to_have_url(f"{server.url}/#/machines/demo-table")
    expect(page.get_by_test_id("machines").get_by_test_id("only-machine")).to_have_count(1)
    page.goto(f"{server.url}/#/webhooks")
    page.get_by_test_id("to-settings").click()
    expect(page.get_by_test_id("settings")).to_be_visible()


@pytest.mark.parametrize(
    "address",
    [
        "library/paints",
        "library/tools/no-such-tool",
        "history/nothing",
        "machines/no-such-table",
        "settings/nothing",
        "nowhere",
    ],
)
def test_an_unknown_address_says_so(page: Page, server: Running, address: str) -> None:
    page.goto(f"{server.url}/#/{address}")
    expect(page.get_by_test_id("not-found")).to_be_visible()
