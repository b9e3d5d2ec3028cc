"""Options of edges are chosen beside the selected edge, listed, removed and sent with the order."""

from __future__ import annotations

import re
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.steps import choose_board, go_to
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


@pytest.mark.long
def test_the_tool_of_a_chain_is_chosen_and_sent(page: Page, screenshots: Path) -> None:
    address = page.url.partition("#")[0]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        drawing = upload_drawing(client, text.dxf(text.rectangle(320, 220, (8, "CUT")), units=4))
        machines = {one["name"]: one for one in client.get("/api/machines").json()}
    page.goto(f"{address}#/drawings/{drawing['id']}/sheet")
    expect(page.get_by_test_id("canvas")).to_be_visible()
    page.get_by_test_id("machine-select").click()
    page.get_by_role("option", name=machines["demo-table"]["title"]).click()
    go_to(page, "lines")
    page.wait_for_timeout(1500)
    select_left_edge(page)
    page.get_by_test_id("select-menu").click()
    page.get_by_test_id("select-connected").click()
    go_to(page, "process")
    # One knife is no choice.
    expect(page.get_by_test_id("edge-option-cut_depths")).to_be_visible()
    tool = page.get_by_test_id("edge-edge_tools-station")
    expect(tool).to_be_hidden()
    go_to(page, "sheet")
    page.get_by_test_id("machine-select").click()
    page.get_by_role("option", name=machines["fine-router-table"]["title"]).click()
    go_to(page, "process")
    tool.click()
    expect(page.get_by_role("option")).to_have_text(
        ["4 Router", "5 Router 3 mm", "6 Router 1.5 mm"]
    )
    page.get_by_role("option", name="6 Router 1.5 mm").click()
    expect(page.get_by_test_id("edge-choices")).to_contain_text("Tool: Station 6")
    page.get_by_test_id("edge-option-edge_corners").scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "edge-tools.png")
    choose_board(page, "Greyboard 3")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    expect(page.get_by_test_id("changed-edge_tools")).to_contain_text("4 edges · Tool: Station 6")
    job_id = page.url.rpartition("/")[2]
    job = httpx.get(f"{address}api/jobs/{job_id}", timeout=60.0).json()
    (chosen,) = job["edge_tools"]
    assert (sorted(chosen["edges"]), chosen["station"]) == ([0, 1, 2, 3], 6)
    assert b"T6 M6" in httpx.get(f"{address}api/jobs/{job_id}/program", timeout=60.0).content


def test_corners_and_lead_ins_of_edges_are_chosen_by_mouse_and_keyboard_and_sent(
    page: Page, screenshots: Path
) -> None:
    address = page.url.partition("#")[0]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        drawing = upload_drawing(client, text.dxf(text.rectangle(340, 210, (8, "CUT")), units=4))
        machines = {one["name"]: one for one in client.get("/api/machines").json()}
    page.goto(f"{address}#/drawings/{drawing['id']}/sheet")
    expect(page.get_by_test_id("canvas")).to_be_visible()
    page.get_by_test_id("machine-select").click()
    page.get_by_role("option", name=machines["router-table"]["title"], exact=True).click()
    go_to(page, "process")
    page.wait_for_timeout(1500)
    select_left_edge(page)

    corners = page.get_by_test_id("edge-option-edge_corners")
    types = [corners.get_by_test_id(f"edge-edge_corners-type-{one}") for one in "BCD"]
    for one in types:
        one.click()
        expect(corners.locator("[aria-pressed=true]")).to_have_count(1)
        expect(one).to_have_attribute("aria-pressed", "true")
    # The keyboard changes the type, and then the parameter.
    types[1].focus()
    page.keyboard.press("Enter")
    expect(types[1]).to_have_attribute("aria-pressed", "true")
    page.keyboard.press("Tab")
    page.keyboard.press("Space")
    expect(types[2]).to_have_attribute("aria-pressed", "true")
    k = corners.get_by_test_id("edge-edge_corners-k")
    k.focus()
    page.keyboard.type("0.4")

    leads = page.get_by_test_id("edge-option-contour_leads")
    expect(leads.locator("svg").first).to_be_visible()
    leads.get_by_test_id("edge-contour_leads-length").click()
    page.keyboard.type("8")
    page.keyboard.press("Tab")
    approach = leads.get_by_test_id("edge-contour_leads-approach")
    expect(approach).to_be_focused()
    page.keyboard.type("45")
    page.keyboard.press("ArrowUp")
    expect(approach).to_have_value("45.1 °")
    approach.fill("30")
    listed = page.get_by_test_id("edge-choices").get_by_role("listitem")
    expect(listed).to_have_count(2)
    leads.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "edge-corners-and-leads.png")

    choose_board(page, "Greyboard 3")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    job_id = page.url.rpartition("/")[2]
    job = httpx.get(f"{address}api/jobs/{job_id}", timeout=60.0).json()
    (corner,), (lead,) = job["edge_corners"], job["contour_leads"]
    assert (corner["type"], corner["k"], len(corner["edges"])) == ("D", 0.4, 1)
    assert (lead["length"], lead["approach"], lead["edges"]) == (8.0, 30.0, corner["edges"])
    expect(page.get_by_test_id("changed-contour_leads")).to_contain_text("8 mm")
    expect(page.get_by_test_id("changed-edge_corners")).to_contain_text("0.4")
