"""The tracks of a program are put in order with the mouse and the keyboard, and then made so."""

from __future__ import annotations

from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.steps import choose_board, compile_again, go_to
from tests.support.serving.server import upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


def expect_places(items: Locator, *rows: str) -> None:
    """Wait until the list has the edges of these rows in this order."""
    expect(items).to_have_count(len(rows))
    for place, row in enumerate(rows):
        expect(items.nth(place)).to_have_attribute("data-edge", row)


def test_tracks_are_dragged_and_moved_by_keys(page: Page, screenshots: Path) -> None:
    address = page.url.partition("#")[0]
    crease = (8, "CREASE")
    lines = [text.line(x, 20, x, 180, crease) for x in (80, 160, 240)]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        file = text.dxf(text.rectangle(300, 200, (8, "CUT")), *lines, units=4)
        drawing = upload_drawing(client, file)
    page.goto(f"{address}#/drawings/{drawing['id']}/process")
    expect(page.get_by_test_id("no-work-order")).to_be_visible()
    choose_board(page, "E-flute")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    go_to(page, "process")
    items = page.get_by_test_id("work-items").get_by_role("listitem")
    expect(items).to_have_count(4)
    first, second, third, cut = (str(one.get_attribute("data-edge")) for one in items.all())
    expect(page.get_by_test_id("order-numbers").locator("text")).to_have_count(4)

    # With the mouse: the first crease behind the third one.
    grips = items.get_by_test_id("drag-track")
    grips.nth(3).scroll_into_view_if_needed()
    start, end = grips.nth(0).bounding_box(), grips.nth(2).bounding_box()
    assert start is not None
    assert end is not None
    page.mouse.move(start["x"] + 14, start["y"] + 14)
    page.mouse.down()
    page.mouse.move(start["x"] + 14, start["y"] + 30, steps=4)
    page.mouse.move(end["x"] + 14, end["y"] + 16, steps=8)
    page.mouse.up()
    expect(items.nth(2)).to_have_attribute("data-edge", first)
    expect_places(items, second, third, first, cut)
    page.screenshot(path=screenshots / "work-order-1.png")

    # With the keys: the last crease before the one above it.
    grips.nth(2).focus()
    for key in ("Space", "ArrowUp", "Space"):
        page.keyboard.press(key)
        page.wait_for_timeout(300)  # the list moves
    expect_places(items, second, first, third, cut)

    # A cut does not come before a crease, and the page says why.
    items.nth(3).get_by_test_id("track-up").click()
    expect(page.get_by_test_id("order-refused")).to_contain_text("creases are made first")
    expect_places(items, second, first, third, cut)

    compile_again(page)
    expect(page.get_by_test_id("changed-work_order")).to_be_visible(timeout=120_000)
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    job = httpx.get(f"{address}api/jobs/{page.url.rpartition('/')[2]}", timeout=60.0).json()
    assert job["work_order"] == [int(row) for row in (second, first, third, cut)]
    go_to(page, "process")
    expect_places(items, second, first, third, cut)
    page.get_by_test_id("shortest-order").click()
    expect(page.get_by_test_id("shortest-order")).to_be_hidden()


def test_a_bridge_is_placed_by_a_click_and_sent(page: Page, screenshots: Path) -> None:
    address = page.url.partition("#")[0]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        file = text.dxf(text.rectangle(300, 200, (8, "CUT")), units=4)
        drawing = upload_drawing(client, file)
    page.goto(f"{address}#/drawings/{drawing['id']}/sheet")
    choose_board(page, "E-flute")
    go_to(page, "process")
    page.get_by_test_id("next-bridge-width").fill("2")
    page.get_by_test_id("pick-bridge").click()
    canvas = page.get_by_test_id("canvas").bounding_box()
    assert canvas is not None
    tip = page.get_by_test_id("edge-tooltip")
    for step in range(0, int(canvas["width"]), 3):
        page.mouse.move(canvas["x"] + step, canvas["y"] + 0.45 * canvas["height"])
        if tip.count():
            break
    page.mouse.down()
    page.mouse.up()
    listed = page.get_by_test_id("bridge-list").get_by_role("listitem")
    expect(listed).to_have_count(1)
    page.screenshot(path=screenshots / "bridges-1.png")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("changed-bridges")).to_contain_text("1 bridge", timeout=120_000)
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    job = httpx.get(f"{address}api/jobs/{page.url.rpartition('/')[2]}", timeout=60.0).json()
    (bridge,) = job["bridges"]
    assert bridge["width"] == 2.0
    assert 0.2 < bridge["at"] < 0.8
    go_to(page, "process")
    listed.get_by_role("button", name="Remove").click()
    expect(listed).to_have_count(0)
