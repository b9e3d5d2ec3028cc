"""Marks of a printed sheet are clicked in the drawing, and snap to the centres of circles."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.steps import go_to
from tests.browser.test_corridor import drop
from tests.support.writers import dxf_text as text

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]

#: Centre of a printed circle on a blank of 200 × 100 mm.
CENTRE = (100.0, 50.0)


def pixel(page: Page, x: float, y: float) -> tuple[float, float]:
    """Return the pixel of a point of the drawing, which is fitted between the controls."""
    box = page.get_by_test_id("canvas").bounding_box()
    bar = page.get_by_test_id("scale-bar")
    length = re.search(r"[\d.]+", str(bar.text_content()))
    width = bar.locator("span").bounding_box()
    assert box is not None
    assert width is not None
    assert length is not None
    scale = width["width"] / float(length[0])
    # The controls take 56 pixels at the left, 108 above, 64 at the right and 104 below.
    middle = (box["x"] + (box["width"] - 8) / 2.0, box["y"] + (box["height"] + 4) / 2.0)
    return middle[0] + scale * (x - CENTRE[0]), middle[1] - scale * (y - CENTRE[1])


def test_marks_are_clicked_and_snap_to_centres_and_ends(page: Page) -> None:
    circle = text.entity("CIRCLE", (8, "CUT"), (10, CENTRE[0]), (20, CENTRE[1]), (40, 8.0))
    drop(page, "printed.dxf", text.dxf(text.rectangle(200, 100, (8, "CUT")), circle, units=4))
    go_to(page, "sheet")
    marks = page.get_by_test_id("mark")
    page.get_by_test_id("marks-pick").click()
    x, y = pixel(page, *CENTRE)
    page.mouse.move(x + 5, y + 4)
    expect(page.get_by_test_id("mark-cursor")).to_be_attached()
    page.mouse.click(x + 5, y + 4)
    expect(marks).to_have_text(re.compile(r"X 100\.0, Y 50\.0"))
    # Half way along a line there is nothing that a camera can find.
    page.mouse.click(*pixel(page, 60.0, 0.0))
    expect(page.get_by_text("There is no line end, centre of a circle")).to_be_visible()
    corner = pixel(page, 200.0, 100.0)
    page.mouse.click(corner[0] - 4, corner[1] + 4)
    expect(marks).to_have_count(2)
    expect(marks.nth(1)).to_contain_text("X 200.0, Y 100.0")
    expect(page.get_by_test_id("mark-cross")).to_have_count(2)
    page.get_by_test_id("marks-pick").click()
    expect(page.get_by_test_id("mark-cursor")).to_have_count(0)
