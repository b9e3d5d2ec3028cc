"""A sheet on the page: six copies in a few clicks, moved, undone, nested, and ordered."""

from __future__ import annotations

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.accessibility import assert_accessible
from tests.browser.conftest import Running
from tests.browser.steps import go_to
from tests.support.serving.server import square, upload_drawing

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(180),
]


@pytest.fixture
def sheet(page: Page, server: Running) -> Page:
    """The editor of a new layout with a square of 100 mm."""
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False) as client:
        drawing = upload_drawing(client, square())["id"]
    page.goto(f"{server.url}/#/drawings/{drawing}/sheet")
    page.get_by_test_id("lay-out").click()
    expect(page.get_by_test_id("sheet-copy")).to_have_count(1)
    return page


def test_six_copies_are_laid_out_and_ordered(sheet: Page) -> None:
    # With the click on "Lay out", this makes four clicks.
    sheet.get_by_test_id("placed-columns").click()
    sheet.keyboard.press("Control+A")
    sheet.keyboard.type("3")
    sheet.keyboard.press("Tab")
    sheet.keyboard.press("Control+A")
    sheet.keyboard.type("2")
    expect(sheet.get_by_test_id("sheet-copy")).to_have_count(6)
    expect(sheet.get_by_test_id("layout-use")).to_contain_text("copies: 6")
    sheet.get_by_test_id("layout-order").click()
    expect(sheet.get_by_test_id("step-process")).to_have_attribute("aria-current", "step")
    go_to(sheet, "lines")
    expect(sheet.get_by_test_id("drawing-size")).to_contain_text("310")


def test_the_remnant_of_a_sheet_is_kept_and_used_next(sheet: Page) -> None:
    # 1,200 × 800 mm with a square of 100 mm at 10, 10 and a gap of 5 mm.
    sheet.get_by_test_id("keep-remnant").click()
    sheet.get_by_test_id("stock").click()
    kept = sheet.get_by_test_id("stock-sheet").filter(has_text="1,085 × 800 mm")
    kept.get_by_role("button").first.click()
    expect(sheet.get_by_test_id("layout-width")).to_have_value("1085")
    kept.get_by_role("button", name="out of the stock").click()
    expect(kept).to_have_count(0)


def test_a_copy_is_moved_and_collides_until_it_is_undone(sheet: Page) -> None:
    sheet.get_by_role("button", name="once more").click()
    copies = sheet.get_by_test_id("sheet-copy")
    expect(copies).to_have_count(2)
    expect(copies.first).to_have_attribute("data-colliding", "true")
    expect(sheet.get_by_test_id("layout-order")).to_be_disabled()
    sheet.get_by_test_id("sheet-canvas").focus()
    for _ in range(10):
        sheet.keyboard.press("Shift+ArrowRight")
    expect(copies.first).to_have_attribute("data-colliding", "false")
    expect(sheet.get_by_test_id("placed-x")).to_have_value("120")
    sheet.get_by_test_id("layout-undo").click()
    sheet.get_by_test_id("layout-undo").click()
    expect(copies.first).to_have_attribute("data-colliding", "true")
    sheet.get_by_test_id("layout-redo").click()
    box = copies.nth(1).bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    sheet.mouse.move(x, y)
    sheet.mouse.down()
    sheet.mouse.move(x + 3 * box["width"], y - box["height"], steps=5)
    sheet.mouse.up()
    expect(copies.first).to_have_attribute("data-colliding", "false")
    assert_accessible(sheet)


def test_copies_are_nested_and_the_search_is_stopped(sheet: Page) -> None:
    sheet.get_by_test_id("nest-count").fill("6")
    sheet.get_by_label("Time (s)").fill("600")
    sheet.get_by_test_id("nest").click()
    expect(sheet.get_by_test_id("sheet-copy")).to_have_count(6)
    expect(sheet.get_by_test_id("nest-found")).to_contain_text("Board use")
    sheet.get_by_test_id("nest-stop").click()
    expect(sheet.get_by_test_id("nest")).to_be_visible()
    sheet.get_by_test_id("layout-save").click()
    expect(sheet.get_by_test_id("layout-save")).to_be_disabled()
    expect(sheet.get_by_test_id("layout-fault")).to_have_text("")
    sheet.reload()
    expect(sheet.get_by_test_id("sheet-copy")).to_have_count(6)
