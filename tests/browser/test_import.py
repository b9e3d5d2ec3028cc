"""From a drawing that says too little to a customer's profile that says it all, click by click."""

from __future__ import annotations

import re
import tomllib
from itertools import pairwise
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

import dxf_text as text

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(240)]

#: 4 × 3 of a unit that nobody says, with three lines on a layer that says nothing.
CORNERS = ((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0))
SILENT = text.dxf(
    *(text.line(*start, *end, (8, "CUT")) for start, end in pairwise(CORNERS)),
    text.line(0.5, 1.0, 3.5, 1.0, (8, "INNER"), (62, 1)),
    text.line(0.5, 1.5, 3.5, 1.5, (8, "INNER"), (62, 1)),
    text.line(0.5, 2.0, 3.5, 2.0, (8, "INNER"), (62, 30)),
    units=None,
)
#: Millimetres, a title, and an edge that lies on another.
NOTE = "0\nTEXT\n8\nNOTES\n10\n0\n20\n0\n40\n5\n1\nRev. B\n"
MESSY = text.dxf(
    *(
        text.line(100.0 * x0, 100.0 * y0, 100.0 * x1, 100.0 * y1, (8, "CUT"))
        for (x0, y0), (x1, y1) in pairwise(CORNERS)
    ),
    text.line(50.0, 0.0, 250.0, 0.0, (8, "CUT")),
    NOTE,
)


def choose(page: Page, *files: tuple[str, bytes]) -> None:
    page.get_by_test_id("file-input").set_input_files(
        [{"name": name, "mimeType": "image/vnd.dxf", "buffer": data} for name, data in files]
    )
    # The first reading of a fresh server waits for its processes to start.
    expect(page.get_by_role("heading", name=files[-1][0])).to_be_visible(timeout=60_000)


def test_questions_are_answered_and_corrections_become_a_customers_profile(
    page: Page, screenshots: Path
) -> None:
    choose(page, ("silent.dxf", SILENT))
    expect(page.get_by_test_id("unit-in")).to_contain_text("101.6 × 76.2")
    expect(page.get_by_test_id("drawing-size")).to_contain_text("unit not known")
    page.screenshot(path=screenshots / "import-1-asked.png")
    page.get_by_test_id("unit-in").click()
    expect(page.get_by_test_id("drawing-size")).to_have_text(re.compile(r"^101\.6 × 76\.2"))
    expect(page.get_by_test_id("drawing-inches")).to_have_text(re.compile(r"^4\.00 × 3\.00"))

    # Two questions, of two colours: each in one click, and back again.
    expect(page.get_by_test_id("question")).to_have_count(2)
    page.get_by_test_id("question").first.get_by_test_id("answer-crease").click()
    expect(page.get_by_test_id("question")).to_have_count(1)
    page.get_by_test_id("question").first.get_by_test_id("answer-perforation").click()
    expect(page.get_by_test_id("questions")).to_be_hidden()
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("question")).to_have_count(1)
    page.keyboard.press("Control+Shift+z")
    expect(page.get_by_test_id("questions")).to_be_hidden()

    # One of them is corrected by hand, and says so.
    page.get_by_test_id("legend-perforation").get_by_role("button").first.click()
    expect(page.get_by_test_id("why")).to_have_text("Decided by hand")
    page.get_by_test_id("type-half-cut").click()
    expect(page.get_by_test_id("legend-half-cut")).to_be_visible()

    # What was learned is shown before it is kept.
    lesson = page.get_by_test_id("lesson").filter(has_text="crease")
    expect(lesson).to_contain_text('layer "INNER", colour 1')
    lesson.hover()
    page.screenshot(path=screenshots / "import-2-learned.png")
    lesson.get_by_test_id("customer").fill("Acme & Söhne")
    lesson.get_by_test_id("keep-lesson").click()
    expect(page.get_by_test_id("profile-select")).to_have_value("Acme & Söhne")
    expect(page.get_by_test_id("lesson")).to_have_count(1)
    page.get_by_test_id("keep-lesson").click()
    expect(page.get_by_test_id("lesson")).to_have_count(0)

    # Its rules count what they take, and it goes out as TOML.
    page.get_by_test_id("edit-profile").click()
    expect(page.get_by_test_id("rule")).to_have_count(2)
    expect(page.get_by_test_id("rule-edges").nth(0)).to_have_text("1 edge")
    expect(page.get_by_test_id("rule-edges").nth(1)).to_have_text("2 edges")
    page.get_by_role("combobox", name="Line type of rule 2").click()
    page.get_by_role("option", name="Combi").click()
    expect(page.get_by_test_id("profile-outcome")).to_contain_text("Nothing in this drawing")
    page.screenshot(path=screenshots / "import-3-profile.png")
    with page.expect_download() as download:
        page.get_by_test_id("export-profile").click()
    kept = tomllib.loads(Path(download.value.path()).read_text("utf-8"))
    assert [rule["type"] for rule in kept["rule"]] == ["half-cut", "crease"]
    page.get_by_role("button", name="Discard").click()

    # Undo takes the second rule back, then the profile.
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("lesson")).to_have_count(1)
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("lesson")).to_have_count(2)
    expect(page.get_by_test_id("profile-select")).not_to_have_value("Acme & Söhne")
    page.wait_for_function("fetch('/api/profiles/acme-sohne').then((one) => one.status === 404)")


def test_the_report_adds_up_and_leads_to_the_edges(page: Page, screenshots: Path) -> None:
    choose(page, ("first.dxf", SILENT), ("messy.dxf", MESSY))
    # Around 1,400 mm, and 200 mm of them twice.
    expect(page.get_by_test_id("report-drawn")).to_have_text(re.compile(r"^1600"))
    merged = page.get_by_test_id("report-merged")
    expect(merged).to_contain_text("1 edge")
    merged.click()
    expect(page.get_by_test_id("inspector")).to_contain_text("merged")
    page.get_by_test_id("report-dropped").click()
    expect(page.get_by_test_id("report-groups")).to_contain_text("TEXT")
    page.screenshot(path=screenshots / "import-4-report.png")
    # The other file was read too.
    page.get_by_test_id("close-drawing").click()
    expect(page.get_by_test_id("drawing-row").filter(has_text="first.dxf")).to_be_visible()
