"""The tracks of a program are put in order with the mouse and the keyboard, and then made so."""

from __future__ import annotations

from itertools import pairwise
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
        expect(items.nth(place)).to_have_attribute("data-id", row)


def drag(page: Page, grip: Locator, target: Locator) -> None:
    """Drag one handle to another one with the mouse."""
    target.scroll_into_view_if_needed()
    grip.scroll_into_view_if_needed()
    start, end = grip.bounding_box(), target.bounding_box()
    assert start is not None
    assert end is not None
    page.mouse.move(start["x"] + 14, start["y"] + 14)
    page.mouse.down()
    way = 1 if end["y"] > start["y"] else -1
    page.mouse.move(start["x"] + 14, start["y"] + 14 + 16 * way, steps=4)
    page.mouse.move(end["x"] + 14, end["y"] + 14 + 2 * way, steps=8)
    page.mouse.up()


def move_by_keys(page: Page, grip: Locator, *arrows: str) -> None:
    grip.focus()
    for key in ("Space", *arrows, "Space"):
        page.keyboard.press(key)
        page.wait_for_timeout(300)  # the list moves


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
    first, second, third, cut = (str(one.get_attribute("data-id")) for one in items.all())
    expect(page.get_by_test_id("order-numbers").locator("text")).to_have_count(4)

    # With the mouse: the first crease behind the third one.
    grips = items.get_by_test_id("drag-track")
    drag(page, grips.nth(0), grips.nth(2))
    expect_places(items, second, third, first, cut)
    page.screenshot(path=screenshots / "work-order-1.png")

    # With the keys: the last crease before the one above it.
    move_by_keys(page, grips.nth(2), "ArrowUp")
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


@pytest.mark.long
def test_blanks_are_moved_in_each_operation(page: Page, screenshots: Path) -> None:
    address = page.url.partition("#")[0]
    cut, crease = (8, "CUT"), (8, "CREASE")
    # Three blanks with a crease each; the first one has a window, and a small blank lies in it.
    boxes = [*((x, 0, x + 100, 160) for x in (0, 120, 240)), (20, 20, 80, 80), (30, 30, 50, 50)]
    shapes = [
        text.line(*a, *b, cut)
        for left, low, right, high in boxes
        for a, b in pairwise([(left, low), (right, low), (right, high), (left, high), (left, low)])
    ]
    lines = [text.line(x, 100, x + 100, 100, crease) for x in (0, 120, 240)]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        drawing = upload_drawing(client, text.dxf(*shapes, *lines, units=4))
    page.goto(f"{address}#/drawings/{drawing['id']}/process")
    choose_board(page, "E-flute")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    go_to(page, "process")
    parts = page.locator('[data-testid="work-parts"] > li')
    expect(parts).to_have_count(4)
    # The blank in the window is finished first.
    expect(parts.nth(0)).to_contain_text("1 track in 1 operation")
    small, *usual = (str(one.get_attribute("data-id")) for one in parts.all())
    grips = parts.get_by_test_id("drag-part")
    drag(page, grips.nth(3), grips.nth(1))
    expect_places(parts, small, usual[2], usual[0], usual[1])
    move_by_keys(page, grips.nth(3), "ArrowUp")
    expect_places(parts, small, usual[2], usual[1], usual[0])
    page.screenshot(path=screenshots / "work-order-blanks.png")

    # No blank comes before the one in the window: outlines are cut last.
    parts.nth(1).get_by_test_id("part-up").click()
    expect(page.get_by_test_id("order-refused")).to_contain_text("comes before")
    expect_places(parts, small, usual[2], usual[1], usual[0])

    # Operations keep their order, and tracks are moved within them.
    first = page.locator('[data-testid="work-parts"] > li[data-id="1"]')
    first.get_by_test_id("unfold").first.click()
    layers = first.locator('[data-testid="work-layers"] > li')
    expect(layers).to_have_count(3)
    drag(
        page, layers.nth(1).get_by_test_id("drag-layer"), layers.nth(2).get_by_test_id("drag-layer")
    )
    expect(page.get_by_test_id("order-refused")).to_contain_text("while the sheet still holds it")
    page.screenshot(path=screenshots / "work-order-operations.png")

    compile_again(page)
    expect(page.get_by_test_id("changed-work_order")).to_be_visible(timeout=120_000)
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    go_to(page, "process")
    expect_places(parts, small, usual[2], usual[1], usual[0])
    page.get_by_test_id("work-view").get_by_text("In one list").click()
    expect(page.get_by_test_id("work-items").get_by_role("listitem")).to_have_count(8)


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
