"""Options of edges are chosen beside the selected edge, listed, removed and sent with the order."""

from __future__ import annotations

import re
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.steps import choose_board
from tests.support.serving.server import upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]


def select_left_edge(page: Page) -> None:
    """Click the first edge from the left in the middle of the canvas."""
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    tip = page.get_by_test_id("edge-tooltip")
    for step in range(0, int(box["width"]), 3):
        page.mouse.move(box["x"] + step, box["y"] + 0.45 * box["height"])
        if tip.count():
            break
    page.mouse.down()
    page.mouse.up()
    expect(page.get_by_test_id("inspector")).to_be_visible()


def test_start_direction_and_passes_are_chosen_and_sent(page: Page, screenshots: Path) -> None:
    with httpx.Client(base_url=page.url.partition("#")[0], timeout=60.0) as client:
        drawing = upload_drawing(client, text.dxf(text.rectangle(300, 200, (8, "CUT")), units=4))
    page.goto(f"{page.url.partition('#')[0]}#/drawings/{drawing['id']}/process")
    expect(page.get_by_test_id("canvas")).to_be_visible()
    page.wait_for_timeout(1500)
    select_left_edge(page)
    start = page.get_by_test_id("edge-option-contour_starts")
    start.get_by_test_id("edge-contour_starts-at").check()
    start.get_by_role("slider").press("ArrowRight")
    expect(start).to_contain_text("51%")
    start.get_by_text("Reverse").click()
    passes = page.get_by_test_id("edge-cut_depths-passes")
    passes.fill("2")
    page.get_by_test_id("edge-scope-cut_depths").get_by_text("All of type Cut").click()
    passes.fill("3")
    listed = page.get_by_test_id("edge-choices").get_by_role("listitem")
    expect(listed).to_have_count(3)
    page.screenshot(path=screenshots / "edge-options-1.png")
    # The passes of the edge alone are removed; those of its line type stay.
    listed.filter(has_text="Passes: 2").get_by_role("button", name=re.compile("Remove")).click()
    expect(listed).to_have_count(2)

    choose_board(page, "E-flute")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    address, _, place = page.url.partition("#")
    job = httpx.get(f"{address}api/jobs/{place.rpartition('/')[2]}", timeout=60.0).json()
    (chosen,) = job["contour_starts"]
    assert (chosen["at"], chosen["direction"], len(chosen["edges"])) == (0.51, "reverse", 1)
    (deep,) = job["cut_depths"]
    assert (deep["line_type"], deep["passes"], deep["depth"]) == ("cut", 3, None)
    expect(page.get_by_test_id("changed-contour_starts")).to_contain_text("Direction: Reverse")
    page.screenshot(path=screenshots / "edge-options-2.png")
