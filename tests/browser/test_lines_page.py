"""Edges are selected by area, likeness and list; dimensions stay; commands are found by name."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.accessibility import record_view
from tests.support.serving.server import upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]

#: A rectangle of 300 by 200 mm with two groups of three equal lines, of which nothing is known.
DRAWING = text.dxf(
    text.rectangle(300, 200, (8, "CUT")),
    *(text.line(x, 40, x, 80, (8, "FOO")) for x in (60, 90, 120)),
    *(text.line(x, 120, x, 150, (8, "BAR")) for x in (180, 210, 240)),
)


def open_lines(page: Page) -> str:
    """Open the drawing at its first step; return the id of the drawing."""
    address = page.url.partition("#")[0]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        drawing = upload_drawing(client, DRAWING)
    page.goto(f"{address}#/drawings/{drawing['id']}/lines")
    # The first question is zoomed to.
    expect(page.get_by_test_id("selection")).to_contain_text("3 edges selected")
    return str(drawing["id"])


def draw_around(page: Page, *corners: tuple[float, float]) -> None:
    """Drag along points given as fractions of the canvas."""
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    places = [(box["x"] + x * box["width"], box["y"] + y * box["height"]) for x, y in corners]
    page.mouse.move(*places[0])
    page.mouse.down()
    for place in places[1:]:
        page.mouse.move(*place, steps=3)
    page.mouse.up()


def test_edges_are_selected_by_lasso_likeness_and_list(page: Page, screenshots: Path) -> None:
    open_lines(page)
    selection = page.get_by_test_id("selection")
    # Only the three lines of the question are in view.
    page.get_by_test_id("tool-lasso").click()
    draw_around(page, (0.15, 0.15), (0.85, 0.15), (0.85, 0.85), (0.15, 0.85))
    expect(selection).to_contain_text("3 edges selected")
    page.get_by_test_id("area-bar").get_by_text("Remove").click()
    draw_around(page, (0.4, 0.15), (0.6, 0.15), (0.6, 0.85), (0.4, 0.85))
    expect(selection).to_contain_text("2 edges selected")
    page.get_by_test_id("picture").focus()
    page.keyboard.press("Escape")
    expect(page.get_by_test_id("area-bar")).to_have_count(0)
    page.keyboard.press("a")
    expect(selection).to_contain_text("3 edges selected")
    page.keyboard.press("Escape")
    expect(selection).to_have_count(0)

    page.keyboard.press("l")
    rows = page.get_by_test_id("edge-list").locator("tr[data-row]")
    expect(rows).to_have_count(10)
    page.get_by_test_id("sort-length").click()
    expect(rows.first).to_contain_text("BAR")
    rows.first.click()
    expect(page.get_by_test_id("selection-size")).to_contain_text("30.00 mm")
    page.get_by_test_id("edge-rows").focus()
    page.keyboard.press("Shift+ArrowDown")
    page.keyboard.press("Shift+ArrowDown")
    expect(selection).to_contain_text("3 edges selected")
    page.get_by_label("Layer or number").fill("cut")
    expect(rows).to_have_count(4)
    page.get_by_test_id("select-listed").click()
    expect(selection).to_contain_text("4 edges selected")
    record_view(page, screenshots / "list-of-edges.png")


def test_edges_are_selected_by_a_lasso_that_a_finger_draws(page: Page) -> None:
    page.set_viewport_size({"width": 820, "height": 1180})
    touch = page.context.new_cdp_session(page)
    touch.send("Emulation.setTouchEmulationEnabled", {"enabled": True})
    open_lines(page)
    selection = page.get_by_test_id("selection")

    def send(kind: str, *points: tuple[float, float]) -> None:
        touch_points = [{"x": x, "y": y} for x, y in points]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touch_points})

    def tap(test_id: str) -> None:
        box = page.get_by_test_id(test_id).bounding_box()
        assert box is not None
        send("touchStart", (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2))
        send("touchEnd")

    def draw(*corners: tuple[float, float]) -> None:
        box = page.get_by_test_id("canvas").bounding_box()
        assert box is not None
        places = [(box["x"] + x * box["width"], box["y"] + y * box["height"]) for x, y in corners]
        send("touchStart", places[0])
        for (x, y), (to_x, to_y) in pairwise(places):
            for step in range(1, 7):
                send("touchMove", (x + (to_x - x) * step / 6, y + (to_y - y) * step / 6))
        send("touchEnd")

    tap("tool-lasso")
    expect(page.get_by_test_id("area-bar")).to_be_visible()
    # The two lines at the left of three, then none.
    draw((0.1, 0.1), (0.6, 0.1), (0.6, 0.9), (0.1, 0.9), (0.1, 0.12))
    expect(selection).to_contain_text("2 edges selected")
    # The page has not scrolled under the finger, and a second finger moves the view instead.
    assert page.evaluate("document.scrollingElement.scrollTop") == 0
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    bar = page.get_by_test_id("scale-bar").inner_text()
    send("touchStart", (x - 20, y))
    send("touchStart", (x - 20, y), (x + 20, y))
    for step in range(1, 9):
        send("touchMove", (x - 20 - 15 * step, y), (x + 20 + 15 * step, y))
    send("touchEnd")
    expect(selection).to_contain_text("2 edges selected")
    expect(page.get_by_test_id("scale-bar")).not_to_have_text(bar)


def test_a_kept_dimension_stays_and_is_removed(page: Page) -> None:
    open_lines(page)
    expect(page.get_by_test_id("overall-size")).to_contain_text("300.00 mm")
    page.keyboard.press("m")
    for x, y in ((0, 0), (30, 40)):
        page.get_by_label("X (mm)").fill(str(x))
        page.get_by_label("Y (mm)").fill(str(y))
        page.get_by_role("button", name="Set point").click()
    page.get_by_test_id("keep-dimension").click()
    page.reload()
    page.get_by_test_id("tool-measure").click()
    kept = page.get_by_role("button", name="Remove the dimension 50.00 mm")
    expect(kept).to_have_count(1)
    kept.focus()
    page.keyboard.press("Enter")
    expect(kept).to_have_count(0)


def test_questions_are_answered_by_keys_and_commands_found_by_name(
    page: Page, screenshots: Path
) -> None:
    open_lines(page)
    question = page.get_by_test_id("question")
    first = question.inner_text().splitlines()[0]
    page.keyboard.press(".")
    expect(question).not_to_contain_text(first)
    expect(page.get_by_text("Question 2 of 2")).to_be_visible()
    # The edges of this question are selected as soon as they are zoomed to.
    expect(page.get_by_test_id("inspector")).not_to_contain_text(first.removeprefix("Layer "))
    page.keyboard.press("2")
    expect(page.get_by_test_id("settled")).to_contain_text("1 question answered")
    expect(page.get_by_test_id("inspector")).to_contain_text(first.removeprefix("Layer "))

    page.keyboard.press("Control+k")
    search = page.get_by_test_id("palette")
    search.fill("type cut")
    expect(page.get_by_test_id("command-type-cut")).to_be_visible()
    record_view(page, screenshots / "palette.png")
    page.keyboard.press("Enter")
    # Opened again while it still fades out, the palette keeps what is typed.
    page.keyboard.press("Control+k")
    search.fill("square")
    expect(page.get_by_role("button", name="square.dxf").first).to_be_visible()
    expect(page.get_by_test_id("all-answered")).to_be_visible()
    search.fill("library")
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("library")).to_be_visible()
