"""Options, figures and facts that the page shows from their declarations alone."""

from __future__ import annotations

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.steps import choose_board, open_details
from tests.browser.test_edge_options import select_left_edge
from tests.support.serving.server import upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]


def test_a_note_and_a_feed_are_sent_and_figures_are_shown(page: Page) -> None:
    address = page.url.partition("#")[0]
    with httpx.Client(base_url=address, timeout=60.0) as client:
        drawing = upload_drawing(client, text.dxf(text.rectangle(310, 210, (8, "CUT")), units=4))
    page.goto(f"{address}#/drawings/{drawing['id']}/process")
    expect(page.get_by_test_id("canvas")).to_be_visible()
    page.wait_for_timeout(1500)
    select_left_edge(page)
    page.get_by_test_id("edge-edge_feeds-factor").fill("0.5")
    expect(page.get_by_test_id("edge-choices")).to_contain_text("Feed factor: 0.5")
    page.get_by_test_id("option-program_note").fill("grain up")
    page.get_by_test_id("option-warp").fill("2.5")
    choose_board(page, "E-flute")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send", timeout=120_000)
    open_details(page)
    expect(page.get_by_test_id("figure-lowest_travel")).to_contain_text("Lowest travel")
    expect(page.get_by_test_id("figure-mat_depth")).to_contain_text("Deepest cut into the mat")
    expect(page.get_by_test_id("fact-worked_length")).to_contain_text("Work per copy")
    expect(page.get_by_test_id("fact-program_bytes")).to_contain_text("Size of the program")
    expect(page.get_by_test_id("changed-program_note")).to_contain_text("grain up")
    job_id = page.url.rpartition("/")[2]
    job = httpx.get(f"{address}api/jobs/{job_id}", timeout=60.0).json()
    assert (job["program_note"], job["warp"]) == ("grain up", 2.5)
    assert [choice["factor"] for choice in job["edge_feeds"]] == [0.5]
