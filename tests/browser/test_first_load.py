"""What the start page fetches, and parts of the page that are fetched later."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from tests.browser.accessibility import assert_accessible
from tests.browser.conftest import Running

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("browser"),
    pytest.mark.timeout(600),
]

#: Most bytes of the files of the start page, compressed.
MOST = 350_000
#: Answers of the API are not counted: other tests have stored drawings and jobs on the server.
TRANSFERRED = """performance.getEntriesByType('resource')
    .filter((one) => !new URL(one.name).pathname.startsWith('/api/'))
    .reduce((sum, one) => sum + one.transferSize, 0)"""


def test_the_start_page_fetches_neither_canvas_nor_other_views(
    browser: Browser, server: Running
) -> None:
    page = browser.new_page()
    scripts: list[str] = []
    page.on("request", lambda sent: scripts.append(sent.url.rpartition("/")[2]))
    page.goto(server.url)
    expect(page.get_by_test_id("drawing-row").first).to_be_visible(timeout=60_000)
    expect(page.get_by_test_id("machine-status")).to_contain_text("Demo table")
    fetched = page.evaluate(TRANSFERRED)
    assert 100_000 < fetched <= MOST
    later = re.compile(r"three-|Canvas|\w+Page-")
    assert [name for name in scripts if later.match(name)] == []
    page.goto(f"{server.url}/#/library")
    expect(page.get_by_test_id("library")).to_be_visible()
    assert any(name.startswith("LibraryPage") for name in scripts)
    page.close()


def test_a_part_that_cannot_be_fetched_says_so(browser: Browser, server: Running) -> None:
    # Not the fixture: the browser itself writes the missing file to the console.
    page = browser.new_page()
    parts = re.compile(r"/assets/LibraryPage.*\.js")
    page.route(parts, lambda route: route.fulfill(status=404))
    page.goto(f"{server.url}/#/library")
    failed = page.get_by_test_id("not-fetched")
    expect(failed).to_be_visible()
    assert_accessible(page)
    # Other views are shown as before.
    page.goto(f"{server.url}/#/webhooks")
    expect(page.get_by_test_id("webhooks")).to_be_visible()
    page.goto(f"{server.url}/#/library")
    expect(failed).to_be_visible()
    page.unroute(parts)
    page.get_by_role("button", name="Reload the page").click()
    expect(page.get_by_test_id("library")).to_be_visible()
    page.close()


def test_a_part_that_is_slow_to_fetch_leaves_the_rest_in_place(page: Page, server: Running) -> None:
    waiting: list[Route] = []
    page.route(re.compile(r"/assets/HistoryPage.*\.js"), lambda route: waiting.append(route))
    page.get_by_test_id("history-button").click()
    # Before the list of machines is loaded, its own status has a text that begins likewise.
    expect(page.get_by_role("status").filter(has_text=re.compile("^Loading$"))).to_be_visible()
    expect(page.get_by_test_id("machine-status")).to_contain_text("Demo table")
    page.mouse.move(700, 500)  # no tooltip
    expect(page.get_by_role("tooltip")).to_have_count(0)
    assert_accessible(page)
    waiting[0].continue_()
    expect(page.get_by_text("Ended jobs").first).to_be_visible()
