"""From a dropped DXF file to a finished job, with the actions of an operator at the screen."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from urllib.parse import urljoin

import pytest
from playwright.sync_api import FloatRect, Page, expect

from knifetip.dxf.samples import samples
from tests.browser.accessibility import record_view
from tests.browser.steps import choose_board, compile_again, go_to, open_details
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]

#: A file without a unit, with one layer that is in no profile and one that is in every profile.
ODD = """0
SECTION
2
ENTITIES
0
LINE
8
NOBODY KNOWS
10
0
20
0
11
100
21
0
0
LINE
8
NOBODY KNOWS
10
100
20
0
11
100
21
80
0
LINE
8
CREASE
10
50
20
0
11
50
21
80
0
ENDSEC
0
EOF
"""


def drop(page: Page, name: str, content: bytes) -> None:
    """Drop a file on the page, as from a folder of the desktop."""
    carried = page.evaluate_handle(
        """([name, text]) => {
            const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
            const carried = new DataTransfer();
            carried.items.add(new File([bytes], name));
            return carried;
        }""",
        [name, base64.b64encode(content).decode()],
    )
    page.dispatch_event("body", "dragenter", {"dataTransfer": carried})
    expect(page.get_by_test_id("drop-zone")).to_be_visible()
    page.dispatch_event("body", "drop", {"dataTransfer": carried})
    expect(page.get_by_test_id("drop-zone")).to_be_hidden()
    # Reading the first file takes longer: the server starts its processes.
    expect(page.get_by_role("heading", name=name)).to_be_visible(timeout=60_000)


def compile_on(page: Page, board: str) -> None:
    choose_board(page, board)
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("verdict")).to_be_visible(timeout=120_000)


@contextmanager
def at_station(page: Page) -> Iterator[None]:
    """Go to the station page by the link, and back to the page of the drawing at the end."""
    place = page.url
    page.get_by_test_id("to-station").first.click()
    yield
    page.goto(place)


def start_at_station(page: Page) -> None:
    """Make all checks at the station and press Start, as the person at the machine does."""
    with at_station(page):
        checks, start = page.get_by_test_id("check"), page.get_by_test_id("station-start")
        expect(checks.first).to_be_visible()
        for check in checks.all():
            expect(start).to_be_disabled()
            check.click()
        start.click()
        expect(page.get_by_test_id("station-state")).to_have_text("Running")


def assert_starts_nothing(page: Page) -> None:
    """Check that the page has no control that starts or continues a machine."""
    # A job for the rest of a sheet is ordered everywhere, and waits at its machine like any other.
    starts = "^start|start machine|confirm|continue (job|cutting)|resume|table is ready"
    names = re.compile(starts, re.I)
    for role in ("button", "link", "checkbox"):
        expect(page.get_by_role(role, name=names)).to_have_count(0)


def middle(page: Page) -> FloatRect:
    """Return the middle of the canvas, which no panel covers."""
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    return FloatRect(
        x=box["x"] + 0.2 * box["width"],
        y=box["y"] + 0.2 * box["height"],
        width=0.6 * box["width"],
        height=0.5 * box["height"],
    )


def ink(page: Page) -> int:
    """Return the number of pixels in the middle of the canvas that are brighter than the
    background.
    """
    shot = page.screenshot(clip=middle(page))
    count: int = page.evaluate(
        """async (text) => {
            const image = new Image();
            image.src = "data:image/png;base64," + text;
            await image.decode();
            const canvas = new OffscreenCanvas(image.width, image.height);
            const pen = canvas.getContext("2d");
            pen.drawImage(image, 0, 0);
            const { data } = pen.getImageData(0, 0, image.width, image.height);
            let count = 0;
            for (let at = 0; at < data.length; at += 4) {
                if (Math.max(data[at], data[at + 1], data[at + 2]) > 120) count++;
            }
            return count;
        }""",
        base64.b64encode(shot).decode(),
    )
    return count


@pytest.mark.parametrize(
    ("sample", "board", "types", "tools"),
    [
        (
            "tuck-end-carton.dxf",
            "Folding boxboard 0.4 mm",
            ("cut", "crease"),
            ("Oscillating knife", "Crease wheel"),
        ),
        # The test of copies below runs this drawing too.
        pytest.param(
            "rigid-box-blank.dxf",
            "Greyboard 2.0 mm",
            ("cut", "v-groove"),
            ("Oscillating knife", "V-cutter"),
            marks=pytest.mark.long,
        ),
    ],
)
def test_a_dropped_dieline_is_compiled_sent_confirmed_and_done(
    page: Page,
    screenshots: Path,
    sample: str,
    board: str,
    types: tuple[str, ...],
    tools: tuple[str, ...],
) -> None:
    stem = sample.removesuffix(".dxf")
    drop(page, sample, samples()[sample])
    # All lines are known: the board is asked for first.
    expect(page.get_by_test_id("board-select")).to_be_visible()
    go_to(page, "lines")
    for line_type in types:
        expect(page.get_by_test_id(f"legend-{line_type}")).to_be_visible()
    assert ink(page) > 500
    record_view(page, screenshots / f"{stem}-1-dropped.png")

    compile_on(page, board)
    expect(page.get_by_test_id("verdict")).to_have_attribute("data-accepted", "true")
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send")
    record_view(page, screenshots / f"{stem}-2-verified.png")

    page.get_by_test_id("send").click()
    # The machine is started where it is seen, after the checks.
    expect(page.get_by_test_id("job-state")).to_have_text("Waiting for operator")
    card = page.get_by_test_id("waits-at-machine")
    expect(card).to_contain_text("Waits for the operator at Demo table")
    for word in (board, *tools):
        expect(card).to_contain_text(word)
    assert_starts_nothing(page)
    record_view(page, screenshots / f"{stem}-3-waits.png")
    start_at_station(page)
    expect(page.get_by_test_id("job-state")).to_have_text("Running")
    expect(card).to_be_hidden()
    page.get_by_test_id("hold").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Paused")
    expect(card).to_contain_text("The operator resumes it there")
    assert_starts_nothing(page)
    page.screenshot(path=screenshots / f"{stem}-3-held.png")
    with at_station(page):
        page.get_by_test_id("hands-clear").click()
        page.get_by_test_id("station-resume").click()
        expect(page.get_by_test_id("station-state")).to_have_text("Running")
    expect(page.get_by_test_id("done")).to_be_visible(timeout=120_000)
    expect(page.get_by_test_id("job-state")).to_have_text("Finished")
    record_view(page, screenshots / f"{stem}-4-done.png")


@pytest.mark.long
def test_each_copy_and_the_next_job_wait_for_a_confirmation_and_a_cancel_asks_first(
    page: Page, screenshots: Path
) -> None:
    drop(page, "rigid-box-blank.dxf", samples()["rigid-box-blank.dxf"])
    go_to(page, "sheet")
    page.get_by_test_id("copies").fill("2")
    compile_on(page, "Greyboard 2.0 mm")
    page.get_by_test_id("send").click()
    start_at_station(page)
    state = page.get_by_test_id("job-state")
    expect(state).to_have_text("Waiting for new sheet", timeout=120_000)
    card = page.get_by_test_id("waits-at-machine")
    expect(card).to_contain_text("Copy 1 of 2 is finished.")
    assert_starts_nothing(page)
    page.screenshot(path=screenshots / "copies-1-sheet.png")
    start_at_station(page)
    expect(state).to_have_text("Running")
    page.get_by_test_id("hold").click()
    expect(state).to_have_text("Paused")

    # A second job waits for the machine and states the reason.
    before = str(page.get_by_test_id("program").get_attribute("href"))
    go_to(page, "sheet")
    page.get_by_test_id("copies").fill("1")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("program")).not_to_have_attribute("href", before)
    page.get_by_test_id("send").click()
    expect(page.get_by_test_id("waiting")).to_contain_text("is occupied by job")

    # The first job is cancelled only after a question to the operator.
    page.get_by_test_id("queue-row").filter(has_text="2 copies").first.click()
    expect(state).to_have_text("Paused")
    page.get_by_test_id("cancel").click()
    expect(page.get_by_test_id("confirm-text")).to_contain_text(
        "lifts the tool and releases its stations"
    )
    record_view(page, screenshots / "copies-2-cancel.png")
    page.get_by_test_id("confirm-no").click()
    expect(page.get_by_test_id("confirm-text")).to_be_hidden()
    expect(state).to_have_text("Paused")
    page.get_by_test_id("cancel").click()
    page.get_by_test_id("confirm-yes").click()
    expect(state).to_have_text("Cancelled")

    # Now the second job waits for its confirmation, also in the queue.
    page.get_by_test_id("to-machines").click()
    queued = page.get_by_test_id("queue-of-demo-table").get_by_test_id("waits-at-machine")
    expect(queued).to_contain_text("Greyboard 2.0 mm")
    assert_starts_nothing(page)
    record_view(page, screenshots / "copies-3-queue.png")
    start_at_station(page)
    expect(queued).to_be_hidden()
    page.get_by_test_id("queue-row").first.click()
    expect(page.get_by_test_id("done")).to_be_visible(timeout=120_000)


def colours(page: Page) -> set[tuple[int, int, int]]:
    """Return the colours that more than a few pixels of the canvas have."""
    found: list[list[int]] = page.evaluate(
        """async (text) => {
            const image = new Image();
            image.src = "data:image/png;base64," + text;
            await image.decode();
            const canvas = new OffscreenCanvas(image.width, image.height);
            const pen = canvas.getContext("2d");
            pen.drawImage(image, 0, 0);
            const { data } = pen.getImageData(0, 0, image.width, image.height);
            const count = new Map();
            for (let at = 0; at < data.length; at += 4) {
                const colour = (data[at] << 16) | (data[at + 1] << 8) | data[at + 2];
                count.set(colour, (count.get(colour) ?? 0) + 1);
            }
            const many = [...count].filter(([, pixels]) => pixels > 100);
            return many.map(([colour]) => [colour >> 16, (colour >> 8) & 255, colour & 255]);
        }""",
        base64.b64encode(page.screenshot(clip=middle(page))).decode(),
    )
    return {(red, green, blue) for red, green, blue in found}


def colours_until(
    page: Page, wanted: Callable[[set[tuple[int, int, int]]], bool]
) -> set[tuple[int, int, int]]:
    """Return the colours of the canvas once they are as wanted; as they are after half a minute.

    A frame is drawn some time after what changes it.
    """
    for _ in range(100):
        found = colours(page)
        if wanted(found):
            break
        page.wait_for_timeout(300)
    return found


#: Colours of the two ends of the scale, and of a V-groove.
NOTHING, LIMIT, GROOVE = (0x3F, 0x6D, 0xD7), (0xFA, 0xF1, 0x64), (0xB7, 0x94, 0xFF)


def test_the_verdict_colours_edges_and_bands_show_removed_material(
    page: Page, screenshots: Path
) -> None:
    drop(page, "rigid-box-blank.dxf", samples()["rigid-box-blank.dxf"])
    expect(page.get_by_test_id("colour-mode")).to_be_hidden()
    compile_on(page, "Greyboard 2.0 mm")
    mode = page.get_by_test_id("colour-mode")
    expect(mode).to_have_attribute("data-mode", "types")
    expect(page.get_by_test_id("colour-scale")).to_be_hidden()
    page.get_by_test_id("layer-head").click()
    assert GROOVE in colours_until(page, lambda seen: GROOVE in seen)

    # All deviations are much smaller than the tolerance: the lower end of the scale.
    page.get_by_test_id("colour-deviation").click()
    expect(page.get_by_test_id("colour-scale")).to_contain_text("0.005")
    seen = colours_until(page, lambda seen: NOTHING in seen and GROOVE not in seen)
    assert NOTHING in seen
    assert seen.isdisjoint({LIMIT, GROOVE})
    # The V-cutter runs 3 mm past the ends of a groove inside the board: the upper end.
    page.get_by_test_id("colour-overcut").click()
    expect(page.get_by_test_id("colour-scale")).to_contain_text("3 mm")
    assert colours_until(page, lambda seen: seen >= {NOTHING, LIMIT}) >= {NOTHING, LIMIT}
    page.screenshot(path=screenshots / "rigid-box-blank-6-overcut.png")

    page.get_by_test_id("colour-types").click()
    page.get_by_test_id("layer-swept").click()
    # A groove 1.3 mm deep with flanks at 45°.
    expect(page.get_by_test_id("path-legend")).to_contain_text(re.compile(r"2\.60\smm wide"))
    page.screenshot(path=screenshots / "rigid-box-blank-7-swept.png")


def test_an_unknown_line_type_is_asked_answered_and_undone(page: Page, screenshots: Path) -> None:
    drop(page, "odd.dxf", ODD.encode())
    expect(page.get_by_test_id("unit-mm")).to_be_visible()
    expect(page.get_by_test_id("step-lines")).to_contain_text("2")
    expect(page.get_by_test_id("answer-first")).to_have_text("Answer 2 questions")
    page.screenshot(path=screenshots / "odd-1-asked.png")
    page.get_by_test_id("unit-mm").click()
    expect(page.get_by_test_id("drawing-size")).to_have_text(re.compile(r"^100\.0 × 80\.0"))

    # The edges of the question are selected: its answer has a key.
    expect(page.get_by_test_id("selection")).to_be_visible()
    page.keyboard.press("1")
    expect(page.get_by_test_id("questions")).to_be_hidden()
    expect(page.get_by_test_id("legend-cut")).to_be_visible()
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("question")).to_be_visible()
    expect(page.get_by_test_id("legend-unclassified")).to_be_visible()
    page.keyboard.press("Control+Shift+z")
    expect(page.get_by_test_id("questions")).to_be_hidden()


def test_hover_names_the_edge_and_a_click_changes_its_type(page: Page, screenshots: Path) -> None:
    drop(page, "rigid-box-blank.dxf", samples()["rigid-box-blank.dxf"])
    canvas = page.get_by_test_id("canvas")
    box = canvas.bounding_box()
    assert box is not None
    tip = page.get_by_test_id("edge-tooltip")
    # There is a groove on the vertical centre line of the canvas; its height depends on the layout.
    # An edge is hit within 7 pixels, so every fifth pixel is tried.
    for step in range(0, int(box["height"]), 5):
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + step)
        if tip.count() and "V-groove" in tip.inner_text():
            break
    expect(tip).to_contain_text("V-GROOVE")
    page.mouse.down()
    page.mouse.up()
    expect(page.get_by_test_id("selection")).to_contain_text("1 edge")
    page.screenshot(path=screenshots / "rigid-box-blank-5-chosen.png")
    page.get_by_test_id("type-crease").click()
    go_to(page, "lines")
    expect(page.get_by_test_id("legend-crease")).to_be_visible()


def test_a_file_that_is_no_drawing_is_refused_with_a_message(page: Page, screenshots: Path) -> None:
    page.get_by_test_id("file-input").set_input_files(
        {"name": "letter.dxf", "mimeType": "image/vnd.dxf", "buffer": b"Dear Sir or Madam"}
    )
    report = page.get_by_test_id("report")
    expect(report).to_contain_text("letter.dxf")
    record_view(page, screenshots / "refused.png")
    report.get_by_role("button", name="Close this message").click()
    expect(report).to_be_hidden()


#: A part of 200 × 120 mm with a slot of 4 mm in its upper side, and a window in it.
PART = (
    (0.0, 0.0), (200.0, 0.0), (200.0, 120.0), (152.0, 120.0), (152.0, 80.0), (148.0, 80.0),
    (148.0, 120.0), (0.0, 120.0), (0.0, 0.0),
)  # fmt: skip
WINDOW = ((30.0, 30.0), (90.0, 30.0), (90.0, 80.0), (30.0, 80.0), (30.0, 30.0))
#: Area that the cutter cannot reach.
UNCUT = (0xFF, 0x4F, 0xA3)


def on_router(page: Page, board: str) -> None:
    go_to(page, "sheet")
    page.get_by_test_id("machine-select").click()
    page.get_by_role("option", name="Router table").click()
    compile_on(page, board)


def accept_shortfalls(page: Page, reason: str) -> None:
    """Accept all shortfalls of the open job."""
    page.get_by_test_id("accept-reason").fill(reason)
    page.get_by_test_id("accept-by").fill("Ada")
    page.get_by_test_id("accept-shortfalls").click()


def test_corner_types_of_a_cutter_are_selected_and_unreached_areas_shown(
    page: Page, screenshots: Path
) -> None:
    lines = [text.line(*a, *b, (8, "CUT")) for a, b in [*pairwise(PART), *pairwise(WINDOW)]]
    drop(page, "window.dxf", text.dxf(*lines, units=4))
    # A table with a knife has no corners to choose.
    go_to(page, "process")
    expect(page.get_by_test_id("option-feed_factor")).to_be_visible()
    expect(page.get_by_test_id("corners")).to_be_hidden()
    on_router(page, "Greyboard 3.0 mm")
    # The cutter does not fit into the slot: the user must accept that it is left out.
    verdict = page.get_by_test_id("verdict")
    expect(verdict).to_have_attribute("data-accepted", "false")
    expect(page.get_by_test_id("job-state")).to_have_text("Refused")
    expect(page.get_by_test_id("accept-shortfalls")).to_be_disabled()
    expect(page.get_by_test_id("program")).to_contain_text("Download refused program")
    accept_shortfalls(page, "the slot is cut by hand")
    expect(page.get_by_test_id("program")).to_contain_text("Download machine program")
    expect(verdict).to_have_attribute("data-accepted", "true")
    expect(verdict).to_contain_text("except for 3 accepted shortfalls")
    expect(page.get_by_test_id("acceptance").first).to_contain_text("Ada: the slot is cut by hand")
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send")
    # Four corners of the window, 1.93 mm² each, and the slot: 4 × 40 - 1.9.
    expect(page.get_by_test_id("unreached")).to_contain_text(
        re.compile(r"16\d\smm² in 5 places cannot be reached")
    )
    open_details(page)
    expect(page.get_by_test_id("saved")).to_contain_text(re.compile(r"saves \d+\.\d\ss \(\d+\s%\)"))
    expect(page.get_by_test_id("layer-uncut")).to_have_attribute("aria-pressed", "true")
    page.screenshot(path=screenshots / "router-1-auto.png")

    def pink(seen: set[tuple[int, int, int]]) -> set[tuple[int, int, int]]:
        return {(r, g, b) for r, g, b in seen if r > 1.4 * g and b > g}

    shown = colours_until(page, lambda seen: bool(pink(seen)))
    page.get_by_test_id("layer-uncut").click()
    hidden = colours_until(page, lambda seen: bool(pink(shown - seen)))
    assert pink(shown - hidden), sorted(shown - hidden)

    before = page.get_by_test_id("program").get_attribute("href")
    go_to(page, "process")
    page.get_by_test_id("corner-D").click()
    expect(page.get_by_test_id("corner-D")).to_have_attribute("aria-pressed", "true")
    page.get_by_test_id("pick-corner").click()
    # No cut is in the middle of the canvas: search the left side of the part from the left.
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    tip = page.get_by_test_id("edge-tooltip")
    for step in range(0, int(box["width"]), 4):
        page.mouse.move(box["x"] + step, box["y"] + 0.6 * box["height"])
        if tip.count() and "120" in tip.inner_text():
            break
    page.mouse.down()
    page.mouse.up()
    expect(page.get_by_test_id("single-corners")).to_contain_text("0.0, 0.0")
    page.screenshot(path=screenshots / "router-2-choosing.png")
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("program")).not_to_have_attribute("href", str(before))
    expect(page.get_by_test_id("job-state")).to_have_text("Refused", timeout=60_000)
    accept_shortfalls(page, "as before")
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send")
    page.get_by_test_id("layer-uncut").click()
    page.get_by_test_id("layer-swept").click()
    # The largest area first, then a corner of the window.
    page.get_by_test_id("unreached").click()
    page.get_by_test_id("unreached").click()
    page.wait_for_timeout(600)
    expect(page.get_by_test_id("scale-bar")).to_contain_text(re.compile(r"^[12] mm"))
    page.screenshot(path=screenshots / "router-3-chosen.png")

    go_to(page, "process")
    page.get_by_test_id("interference").get_by_text("Do not create a program").click()
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-state")).to_have_text("Refused", timeout=60_000)
    expect(page.get_by_test_id("reason")).to_contain_text("mm")


def test_the_inspector_shows_the_section_of_a_groove(page: Page, screenshots: Path) -> None:
    drop(page, "rigid-box-blank.dxf", samples()["rigid-box-blank.dxf"])
    on_router(page, "Greyboard 2.0 mm")
    expect(page.get_by_test_id("unreached")).to_contain_text("8 places")
    box = page.get_by_test_id("canvas").bounding_box()
    assert box is not None
    tip = page.get_by_test_id("edge-tooltip")
    for step in range(0, int(box["height"]), 5):
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + step)
        if tip.count() and "V-groove" in tip.inner_text():
            break
    # Three rows at the cursor; the rest in the inspector.
    expect(tip.locator("dt")).to_have_count(2)
    page.mouse.down()
    page.mouse.up()
    inspector = page.get_by_test_id("inspector")
    # A groove 1.3 mm deep with flanks at 45° in a board of 2 mm.
    expect(inspector).to_contain_text(re.compile(r"2\.60\smm at the top"))
    expect(inspector).to_contain_text(re.compile(r"Board thickness under groove\s*0\.70\smm"))
    page.screenshot(path=screenshots / "router-4-groove.png")


@pytest.mark.long
def test_the_shortfalls_of_an_earlier_job_are_accepted_again_in_one_action(
    page: Page, screenshots: Path
) -> None:
    lines = [text.line(*a, *b, (8, "CUT")) for a, b in pairwise(PART)]
    drop(page, "slotted.dxf", text.dxf(*lines, units=4))
    on_router(page, "Greyboard 3.0 mm")
    expect(page.get_by_test_id("accept-reason")).to_have_value("")
    expect(page.get_by_test_id("earlier-exceptions")).to_be_hidden()
    accept_shortfalls(page, "the slot is cut by hand")
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send")
    before = str(page.get_by_test_id("program").get_attribute("href"))

    compile_again(page)
    expect(page.get_by_test_id("program")).not_to_have_attribute("href", before)
    # The acceptance belongs to the first job.
    expect(page.get_by_test_id("job-state")).to_have_text("Refused", timeout=60_000)
    expect(page.get_by_test_id("earlier-exceptions")).to_contain_text("Ada accepted 3 of these")
    expect(page.get_by_test_id("accept-reason")).to_have_value("the slot is cut by hand")
    button = page.get_by_test_id("accept-shortfalls")
    expect(button).to_have_text("Accept the same 3 shortfalls as before")
    page.get_by_test_id("accept-by").fill("")
    expect(button).to_be_disabled()
    page.get_by_test_id("accept-by").fill("Grace")
    record_view(page, screenshots / "accept-again.png")
    button.click()
    expect(page.get_by_test_id("job-state")).to_have_text("Ready to send")
    expect(page.get_by_test_id("acceptance").first).to_contain_text(
        "Grace: the slot is cut by hand"
    )


#: Colour of the outline of a sheet.
SHEET = (0xC9, 0xB4, 0x8A)


def nearest(colour: tuple[int, int, int], shown: set[tuple[int, int, int]]) -> int:
    """Return the least difference of a colour from those on the canvas: thin lines are blended."""
    return min(max(abs(a - b) for a, b in zip(colour, one, strict=True)) for one in shown)


@pytest.mark.long
def test_a_sheet_cut_to_size_and_the_least_lift_are_chosen_for_a_job(
    page: Page, screenshots: Path
) -> None:
    outline = [(0, 0), (300, 0), (300, 200), (0, 200), (0, 0)]
    cuts = [text.line(*a, *b, (8, "CUT")) for a, b in pairwise(outline)]
    grooves = [text.line(0, y, 300, y, (8, "V-GROOVE")) for y in range(30, 180, 30)]
    drop(page, "grooved.dxf", text.dxf(*cuts, *grooves, units=4))
    go_to(page, "sheet")
    page.get_by_test_id("sheet-select").click()
    page.get_by_role("option", name="Cut to a rectangle").click()
    expect(page.get_by_test_id("sheet-width")).to_have_value("300")
    small = page.get_by_test_id("sheet-small")
    expect(small).to_be_hidden()
    before = nearest(SHEET, colours(page))
    page.get_by_test_id("sheet-margin").fill("20")
    expect(small).to_contain_text("320.0 × 220.0")
    page.get_by_test_id("sheet-width").fill("320")
    page.get_by_test_id("sheet-height").fill("185")
    expect(small).to_be_visible()
    page.wait_for_timeout(300)
    # The upper edge of the sheet is drawn across the drawing.
    page.screenshot(path=screenshots / "sheet-1-chosen.png")
    seen = colours_until(page, lambda seen: nearest(SHEET, seen) < 45)
    assert nearest(SHEET, seen) < 45 < before
    page.get_by_test_id("sheet-margin").fill("0")
    page.get_by_test_id("sheet-width").fill("300")
    page.get_by_test_id("sheet-height").fill("200")
    expect(small).to_be_hidden()
    go_to(page, "process")
    page.get_by_test_id("least-lift").check()
    compile_on(page, "Greyboard 2.0 mm")
    expect(page.get_by_test_id("verdict")).to_have_attribute("data-accepted", "true")
    page.screenshot(path=screenshots / "sheet-2-compiled.png")
    href = page.get_by_test_id("program").get_attribute("href")
    assert href is not None
    program = page.request.get(urljoin(page.url, href)).text()
    assert "(sheet 300 x 200 margin 0)" in program
