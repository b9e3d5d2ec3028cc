"""Distances are measured and lines drawn, by mouse and by numbers; undo removes the lines."""

from __future__ import annotations

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.support.serving.server import upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]


def open_lines(page: Page) -> str:
    """Open a rectangle of 300 by 200 mm at its first step; return the id of the drawing."""
    address = page.url.partition("#")[0]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        drawing = upload_drawing(client, text.dxf(text.rectangle(300, 200, (8, "CUT")), units=4))
    page.goto(f"{address}#/drawings/{drawing['id']}/lines")
    expect(page.get_by_test_id("tool-measure")).to_be_enabled()
    return str(drawing["id"])


def set_point(page: Page, x: float, y: float) -> None:
    """Give a point of the drawing tool by numbers."""
    page.get_by_label("X (mm)").fill(str(x))
    page.get_by_label("Y (mm)").fill(str(y))
    page.get_by_role("button", name="Set point").click()


def test_a_distance_is_measured_between_points(page: Page) -> None:
    open_lines(page)
    page.get_by_test_id("tool-measure").click()
    bar = page.get_by_test_id("draft")
    set_point(page, 0, 0)
    expect(bar).to_contain_text("Click the second point.")
    set_point(page, 30, 40)
    expect(bar).to_contain_text("50.00 mm")
    expect(bar).to_contain_text("53.1°")
    page.get_by_test_id("picture").focus()
    page.keyboard.press("Escape")
    expect(bar).to_contain_text("Click the first point.")
    page.keyboard.press("Escape")
    expect(bar).to_have_count(0)


def test_a_click_near_an_edge_chooses_a_point_of_it(page: Page) -> None:
    open_lines(page)
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    page.get_by_test_id("tool-measure").click()
    bar = page.get_by_test_id("draft")
    expect(bar).to_contain_text("Click the first point.")
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(bar).to_contain_text("Click the second point.")
    page.mouse.click(box["x"] + box["width"] / 2 + 60, box["y"] + box["height"] / 2)
    expect(bar).to_contain_text(" mm · X")


def test_a_line_is_drawn_with_its_type_and_undone(page: Page) -> None:
    id = open_lines(page)
    page.get_by_test_id("tool-line").click()
    page.get_by_label("Line type of the new edge").select_option("crease")
    set_point(page, 0, 100)
    set_point(page, 300, 100)
    types = page.get_by_test_id("legend")
    expect(types).to_contain_text("Crease")
    drawing = httpx.get(f"{page.url.partition('#')[0]}api/v1/drawings/{id}", timeout=60.0).json()
    assert [edit["kind"] for edit in drawing["edits"]] == ["line"]
    assert {row["type"]: row["length"] for row in drawing["counts"]}["crease"] == 300.0
    page.get_by_test_id("undo").click()
    expect(types).not_to_contain_text("Crease")
    page.get_by_test_id("redo").click()
    expect(types).to_contain_text("Crease")
