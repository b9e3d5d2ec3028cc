"""Addresses of the page: tabs of the library, history, machines and settings, and unknown ones."""

from __future__ import annotations

import httpx
import pytest
from playwright.sync_api import Page, expect

from knifetip.dxf.samples import samples
from tests.browser.conftest import Running

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


@pytest.mark.long
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


def test_work_is_sorted_by_its_columns_and_keeps_the_order_in_the_address(
    page: Page, server: Running
) -> None:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, trust_env=False, headers=headers) as api:
        for name, customer in (
            ("corrugated-tray.dxf", "Sorted Z"),
            ("rigid-box-blank.dxf", "Sorted A"),
        ):
            file = (name, samples()[name])
            drawing = api.post("/api/v1/drawings", files={"file": file}).json()
            details = {"customer": customer}
            api.patch(f"/api/v1/drawings/{drawing['id']}", json=details).raise_for_status()
    page.goto(f"{server.url}/#/")
    page.get_by_test_id("work-search").fill("Sorted")
    column = page.get_by_role("columnheader", name="Customer")
    customers = page.locator("[data-testid=drawing-row] td:nth-child(3)")
    expect(column).to_have_attribute("aria-sort", "none")
    page.get_by_test_id("sort-customer").click()
    expect(column).to_have_attribute("aria-sort", "ascending")
    expect(customers.first).to_have_text("Sorted A")
    page.get_by_test_id("sort-customer").click()
    expect(column).to_have_attribute("aria-sort", "descending")
    expect(customers.first).to_have_text("Sorted Z")
    expect(page).to_have_url(f"{server.url}/#/search/Sorted/by/customer/reversed")
    page.reload()
    expect(page.get_by_test_id("work-search")).to_have_value("Sorted")
    expect(column).to_have_attribute("aria-sort", "descending")
    expect(customers.first).to_have_text("Sorted Z")
    expect(page.get_by_test_id("to-work")).to_have_attribute("aria-current", "page")


def test_conditions_on_the_work_are_in_the_address(page: Page, server: Running) -> None:
    page.goto(f"{server.url}/#/")
    page.get_by_test_id("work-progress").select_option("ended")
    expect(page).to_have_url(f"{server.url}/#/state/ended")
    page.get_by_test_id("work-machine").select_option("demo-table")
    expect(page).to_have_url(f"{server.url}/#/state/ended/machine/demo-table")
    search = page.get_by_test_id("work-search")
    search.press_sequentially("no such 100% / job")
    typed = f"{server.url}/#/state/ended/machine/demo-table/search/no%20such%20100%25%20%2F%20job"
    expect(page).to_have_url(typed)
    expect(page.get_by_text("No drawing meets these conditions.")).to_be_visible()
    # The history has one entry for the whole search, and one for each filter.
    page.go_back()
    expect(search).to_have_value("")
    expect(page.get_by_test_id("work-machine")).to_have_value("demo-table")
    page.go_back()
    expect(page.get_by_test_id("work-machine")).to_have_value("")
    expect(page.get_by_test_id("work-progress")).to_have_value("ended")
    page.go_forward()
    page.go_forward()
    expect(search).to_have_value("no such 100% / job")
    # A copied link shows the same.
    copy = page.context.new_page()
    copy.goto(typed)
    expect(copy.get_by_test_id("work-search")).to_have_value("no such 100% / job")
    expect(copy.get_by_test_id("work-progress")).to_have_value("ended")
    copy.close()


@pytest.mark.parametrize(
    "address",
    [
        "library/paints",
        "library/tools/no-such-tool",
        "history/nothing",
        "machines/no-such-table",
        "settings/nothing",
        "nowhere",
        "by/colour",
        "state/lost",
    ],
)
def test_an_unknown_address_says_so(page: Page, server: Running, address: str) -> None:
    page.goto(f"{server.url}/#/{address}")
    expect(page.get_by_test_id("not-found")).to_be_visible()
