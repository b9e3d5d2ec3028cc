"""From an ambiguous drawing to a customer's profile that classifies it, click by click."""

from __future__ import annotations

import re
import tomllib
from itertools import pairwise
from pathlib import Path

import pytest
from playwright.sync_api import FilePayload, Locator, Page, expect

from knifetip.dxf.samples import samples
from tests.browser.accessibility import record_view
from tests.browser.steps import go_to
from tests.support.writers import dxf_text as text
from tests.support.writers.pdf_text import pages

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]

#: A part of 4 × 3 in an unknown unit, with three lines on a layer whose name has no meaning.
CORNERS = ((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0))
INNER = (
    text.line(0.5, 1.0, 3.5, 1.0, (8, "INNER"), (62, 1)),
    text.line(0.5, 1.5, 3.5, 1.5, (8, "INNER"), (62, 1)),
    text.line(0.5, 2.0, 3.5, 2.0, (8, "INNER"), (62, 30)),
)
AMBIGUOUS = text.dxf(
    *(text.line(*start, *end, (8, "CUT")) for start, end in pairwise(CORNERS)), *INNER, units=None
)


def note(content: str, x: float, y: float) -> str:
    return text.entity("TEXT", (8, "NOTES"), (10, x), (20, y), (40, 5), (1, content))


def carton(*more: str) -> bytes:
    """Return a DXF file with a part of 400 × 300 mm and further entities."""
    sides = [(100.0 * x, 100.0 * y) for x, y in CORNERS]
    return text.dxf(*(text.line(*a, *b, (8, "CUT")) for a, b in pairwise(sides)), *more)


#: A part with two texts, an overlapping edge, a line drawn twice, and debris.
FLAWED = carton(
    text.line(50.0, 0.0, 250.0, 0.0, (8, "CUT")),
    note("Rev. B", 350.0, 280.0),
    note("Glue here", 20.0, 20.0),
    text.line(0.0, 150.0, 400.0, 150.0, (8, "CREASE")),
    text.line(0.0, 150.0, 400.0, 150.0, (8, "CREASE")),
    text.line(30.0, 30.0, 30.001, 30.0, (8, "CUT")),
)


def customer_file() -> bytes:
    """Return the sample carton with a frame, texts and repeated edges, like files of customers."""
    frame = ((-12.0, -30.0), (297.0, -30.0), (297.0, 263.0), (-12.0, 263.0), (-12.0, -30.0))
    added = (
        *(text.line(*a, *b, (8, "FRAME")) for a, b in pairwise(frame)),
        note("Tuck end carton 90 x 45 x 129", 160.0, -22.0),
        note("Rev. B", -4.0, -22.0),
        note("Front", 52.0, 122.0),
        note("Glue here", 3.0, 100.0),
        text.line(105.0, 61.0, 105.0, 190.0, (8, "CREASE")),
        text.line(30.0, 0.0, 80.0, 0.0, (8, "CUT")),
        text.line(60.0, 60.5, 90.0, 60.5, (8, "CREASE")),
        text.line(190.0, 120.0, 190.002, 120.0, (8, "CUT")),
        text.line(165.0, 150.0, 225.0, 150.0, (8, "INNER"), (62, 1)),
    )
    head, end, tail = samples()["tuck-end-carton.dxf"].rpartition(b"  0\nENDSEC\n  0\nSECTION\n")
    return head + "".join(added).encode() + end + tail


def upload_files(page: Page, *files: tuple[str, bytes]) -> None:
    page.get_by_test_id("file-input").set_input_files(
        [FilePayload(name=name, mimeType="image/vnd.dxf", buffer=data) for name, data in files]
    )
    # Reading the first file takes longer: the server starts its processes.
    expect(page.get_by_role("heading", name=files[-1][0])).to_be_visible(timeout=60_000)
    expect(page).to_have_url(re.compile("/drawings/[^/]+/"))
    go_to(page, "lines")


def replace_drawing(page: Page, name: str, content: bytes) -> None:
    """Close the open drawing and upload another one."""
    page.get_by_test_id("to-work").click()
    upload_files(page, (name, content))


def questions(page: Page) -> Locator:
    return page.get_by_test_id("question")


def expect_questions(page: Page, count: int) -> None:
    """Expect a number of questions, of which one is shown."""
    expect(page.get_by_test_id("step-lines")).to_contain_text(str(count))
    expect(questions(page)).to_have_count(1)


def screenshot(page: Page) -> bytes:
    """Return a screenshot of the canvas after it has been redrawn."""
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => setTimeout(done)))")
    return page.get_by_test_id("canvas").screenshot()


def test_an_unknown_unit_is_asked_with_sizes_and_evidence(page: Page, screenshots: Path) -> None:
    upload_files(page, ("silent.dxf", AMBIGUOUS))
    expect(page.get_by_test_id("unit-in")).to_contain_text("101.6 × 76.2")
    expect(page.get_by_test_id("unit-m")).to_contain_text("4000.0 × 3000.0")
    expect(page.get_by_test_id("drawing-size")).to_contain_text("unit unknown")
    expect(page.get_by_test_id("scale-bar")).to_contain_text("file units")
    # The evidence for the likeliest unit is shown at once, for the others on demand.
    likely = page.locator("[data-likely=true][data-testid^=unit-]")
    expect(likely).to_contain_text("most likely")
    expect(likely).to_contain_text("the file states no unit")
    other = page.locator("[data-likely=false][data-testid^=unit-]").first
    expect(other).not_to_contain_text("multiples of")
    page.get_by_test_id("unit-evidence").click()
    expect(other).to_contain_text("multiples of")
    record_view(page, screenshots / "import-1-asked.png")

    page.get_by_test_id("unit-in").click()
    expect(page.get_by_test_id("drawing-size")).to_have_text(re.compile(r"^101\.6 × 76\.2"))
    expect(page.get_by_test_id("drawing-inches")).to_have_text(re.compile(r"^4\.00 × 3\.00"))
    expect(page.get_by_test_id("scale-bar")).to_contain_text("mm")
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("drawing-size")).to_contain_text("unit unknown")
    page.keyboard.press("Control+Shift+z")
    expect(page.get_by_test_id("drawing-size")).to_have_text(re.compile(r"^101\.6 × 76\.2"))


def test_one_answer_about_swapped_rules_shows_and_decides_both(
    page: Page, screenshots: Path
) -> None:
    outline = ((0, 0, 300, 0), (300, 0, 300, 200), (300, 200, 0, 200), (0, 200, 0, 0))
    folds = ((100, 0, 100, 200), (200, 0, 200, 200))
    lines = [text.line(*ends, (8, "CREASE")) for ends in outline]
    lines += [text.line(*ends, (8, "CUT")) for ends in folds]
    upload_files(page, ("swapped.dxf", text.dxf(*lines)))
    expect(questions(page)).to_have_count(1)
    question = questions(page).first
    expect(question).to_contain_text("Layer CREASE")
    following = question.get_by_test_id("following-edges")
    expect(following).to_contain_text("Layer CUT")
    expect(following).to_contain_text("2 edges · 400 mm")
    expect(following).to_contain_text("Crease if the answer is Cut")
    expect(following).to_contain_text("Cut if the answer is Crease")
    record_view(page, screenshots / "import-swapped.png")
    # Hovering over an answer shows its effect on both layers.
    page.mouse.move(5, 5)
    still = screenshot(page)
    question.get_by_test_id("answer-cut").hover()
    assert screenshot(page) != still
    question.get_by_test_id("answer-cut").click()
    expect(questions(page)).to_have_count(0)
    page.keyboard.press("Control+z")
    expect(questions(page)).to_have_count(1)
    expect(following).to_contain_text("2 edges")


def test_each_question_is_answered_by_one_click_and_undone_in_one_step(page: Page) -> None:
    upload_files(page, ("silent.dxf", AMBIGUOUS))
    page.get_by_test_id("unit-in").click()
    expect_questions(page, 2)
    # Hovering over an answer shows its effect.
    page.mouse.move(5, 5)
    still = screenshot(page)
    answer = questions(page).first.get_by_test_id("answer-crease")
    answer.hover()
    assert screenshot(page) != still
    answer.click()
    expect_questions(page, 1)
    # With the keyboard only; then the next question has the focus.
    page.keyboard.press("Control+z")
    expect_questions(page, 2)
    expect(answer).to_be_enabled()
    answer.press("Enter")
    expect_questions(page, 1)
    expect(questions(page).locator("[data-answer]").first).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("questions")).to_be_hidden()
    for left in (1, 2):
        page.keyboard.press("Control+z")
        expect_questions(page, left)
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("unit-in")).to_be_visible()


def test_an_edge_shows_the_reason_for_its_line_type_and_alternatives(page: Page) -> None:
    upload_files(page, ("inner.dxf", carton(text.line(0.0, 150.0, 400.0, 150.0, (8, "INNER")))))
    page.get_by_title("Select all edges on layer INNER with colour 7").click()
    inspector = page.get_by_test_id("inspector")
    expect(inspector.get_by_test_id("why")).to_contain_text("divides two panels")
    expect(inspector).to_contain_text(re.compile(r"\d\d % confidence"))
    inspector.get_by_test_id("alternative-perforation").click()
    expect(page.get_by_test_id("legend-perforation")).to_be_visible()
    expect(inspector.get_by_test_id("why")).to_have_text("the user set the line type of the edge")
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("legend-perforation")).to_be_hidden()
    expect(inspector.get_by_test_id("why")).to_contain_text("divides two panels")


def test_corrections_become_a_profile_that_classifies_the_next_drawing(
    page: Page, screenshots: Path
) -> None:
    upload_files(page, ("first-of-acme.dxf", AMBIGUOUS))
    page.get_by_test_id("unit-in").click()
    questions(page).first.get_by_test_id("answer-crease").click()
    expect_questions(page, 1)
    questions(page).first.get_by_test_id("answer-half-cut").click()
    expect(page.get_by_test_id("questions")).to_be_hidden()

    # The effect of learned rules is counted and shown before they are saved.
    lesson = page.get_by_test_id("lesson").filter(has_text="crease")
    expect(lesson).to_contain_text('layer "INNER", colour 1')
    expect(lesson).to_contain_text("2 edges")
    page.mouse.move(5, 5)
    still = screenshot(page)
    lesson.hover()
    assert screenshot(page) != still
    page.screenshot(path=screenshots / "import-2-learned.png")
    lesson.get_by_test_id("customer").fill("Acme & Söhne")
    lesson.get_by_test_id("keep-lesson").click()
    expect(page.get_by_test_id("profile-select")).to_have_value("Acme & Söhne")
    expect(page.get_by_test_id("lesson")).to_have_count(1)
    page.get_by_test_id("keep-lesson").click()
    expect(page.get_by_test_id("lesson")).to_have_count(0)

    # The next drawing of the customer is classified by the profile without a question.
    replace_drawing(
        page,
        "next.dxf",
        carton(*(text.line(0.0, y, 400.0, y, (8, "INNER"), (62, 30)) for y in (100.0, 200.0))),
    )
    expect(page.get_by_test_id("legend-half-cut")).to_be_hidden()
    page.get_by_test_id("profile-select").click()
    page.get_by_role("option", name="Acme & Söhne").click()
    expect(page.get_by_test_id("legend-half-cut")).to_contain_text("2")
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("legend-half-cut")).to_be_hidden()

    # In the first drawing the undo steps are gone; the saved profile remains.
    page.get_by_test_id("to-work").click()
    page.get_by_role("link", name="first-of-acme.dxf").first.click()
    go_to(page, "lines")
    expect(page.get_by_test_id("profile-select")).to_have_value("Acme & Söhne")
    expect(page.get_by_test_id("undo")).to_be_disabled()


@pytest.mark.long
def test_a_profile_is_edited_exported_and_imported_as_toml(page: Page, screenshots: Path) -> None:
    upload_files(
        page,
        (
            "inner.dxf",
            carton(
                *(
                    text.line(0.0, y, 400.0, y, (8, "INNER"), (62, colour))
                    for y, colour in ((100.0, 1), (200.0, 30))
                )
            ),
        ),
    )
    page.get_by_test_id("edit-profile").click()
    page.get_by_test_id("profile-title").fill("Bolt")
    page.get_by_test_id("add-rule").click()
    page.get_by_label("Layer name of rule 1").fill("INN*")
    expect(page.get_by_test_id("rule-edges")).to_have_text("2 edges")
    page.get_by_role("combobox", name="Line type of rule 1").click()
    page.get_by_role("option", name="Combi").click()
    expect(page.get_by_test_id("profile-outcome")).to_contain_text("type of 2 edges")
    record_view(page, screenshots / "import-3-profile.png")

    # Undo in the editor affects the profile only, not the drawing.
    page.get_by_test_id("undo").click()
    expect(page.get_by_test_id("profile-outcome")).to_contain_text("type of 2 edges")
    page.get_by_test_id("undo").click()
    expect(page.get_by_label("Layer name of rule 1")).to_have_value("")
    page.get_by_test_id("redo").click()
    page.get_by_test_id("redo").click()
    expect(page.get_by_label("Layer name of rule 1")).to_have_value("INN*")
    # Unsaved edits remain in the editor.
    page.get_by_role("button", name="Back").click()
    page.get_by_test_id("edit-profile").click()
    expect(page.get_by_label("Layer name of rule 1")).to_have_value("INN*")
    page.get_by_test_id("save-profile").click()
    expect(page.get_by_role("heading", name="Bolt")).to_be_visible()
    expect(page.get_by_test_id("undo")).to_be_enabled()

    with page.expect_download() as download:
        page.get_by_test_id("export-profile").click()
    written = Path(download.value.path()).read_bytes()
    (rule,) = tomllib.loads(written.decode())["rule"]
    assert (rule["layer"], rule["type"]) == (["INN*"], "combi")

    # The file, changed in a text editor, is imported again under its name.
    page.get_by_test_id("import-profile").set_input_files(
        {
            "name": "bolt.toml",
            "mimeType": "application/toml",
            "buffer": written.replace(b"combi", b"perforation").replace(b"INN*", b"INNER"),
        }
    )
    expect(page.get_by_label("Layer name of rule 1")).to_have_value("INNER")
    page.get_by_role("button", name="Back").click()
    expect(page.get_by_test_id("legend-perforation")).to_contain_text("2")
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("legend-combi")).to_contain_text("2")
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("legend-combi")).to_be_hidden()
    page.wait_for_function("fetch('/api/profiles/bolt').then((one) => one.status === 404)")
    page.keyboard.press("Control+Shift+z")
    expect(page.get_by_test_id("legend-combi")).to_contain_text("2")

    # A file that is no profile is refused with a message.
    page.get_by_test_id("edit-profile").click()
    page.get_by_test_id("import-profile").set_input_files(
        {
            "name": "wrong.toml",
            "mimeType": "application/toml",
            "buffer": b"title = 'W'\n[[rule]]\ntype = 'glue'",
        }
    )
    expect(page.get_by_test_id("report")).to_contain_text("glue")


def test_lengths_in_the_report_add_up_and_its_rows_select_edges(
    page: Page, screenshots: Path
) -> None:
    upload_files(page, ("first.dxf", AMBIGUOUS), ("messy.dxf", FLAWED))
    # Outline 1,400 mm and crease 400 mm; 200 mm of the outline and the crease are drawn twice.
    expect(page.get_by_test_id("report-drawn")).to_have_text(re.compile(r"^2000"))
    groups = page.get_by_test_id("report-groups")
    selection = page.get_by_test_id("selection")
    # A click on a group of edges selects them on the canvas.
    groups.get_by_text("lies completely on other edges").click()
    expect(selection).to_contain_text(re.compile(r"1 edge selected · 200\smm"))
    expect(page.get_by_test_id("inspector")).to_contain_text("merged")
    # A click on a duplicate entity selects the kept one.
    groups.get_by_text("is drawn twice").click()
    page.get_by_test_id("entity").click()
    expect(selection).to_contain_text(re.compile(r"1 edge selected · 400\smm"))
    groups.get_by_text("is drawn twice").click()
    # Texts have no edge: their position is marked.
    groups.get_by_text("is a text, which is not cut").click()
    expect(page.get_by_test_id("entity")).to_have_count(2)
    page.get_by_test_id("entity").filter(has_text="Glue here").click()
    expect(page.get_by_test_id("entity").filter(has_text="Glue here")).to_have_attribute(
        "aria-pressed", "true"
    )
    expect(page.get_by_test_id("selection")).to_be_hidden()
    expect(page.get_by_test_id("picture")).to_have_attribute("data-pin", "20,20,20,20")
    record_view(page, screenshots / "import-4-report.png")
    page.keyboard.press("Escape")
    expect(page.get_by_test_id("picture")).not_to_have_attribute("data-pin", "20,20,20,20")
    # The report is filtered by outcome.
    page.get_by_text("Merged", exact=True).last.click()
    expect(page.get_by_test_id("report-dropped")).to_have_count(0)
    expect(page.get_by_test_id("report-merged")).to_have_count(2)
    # The other file of the same upload was read.
    page.get_by_test_id("to-work").click()
    expect(page.get_by_test_id("drawing-row").filter(has_text="first.dxf").first).to_be_visible()


def test_a_refused_file_has_a_message_with_a_hint_and_the_others_are_read(page: Page) -> None:
    cut_short = FLAWED[: FLAWED.rindex(b"ENDSEC") - 40]
    upload_files(page, ("short.dxf", cut_short), ("whole.dxf", FLAWED))
    report = page.get_by_test_id("report")
    expect(report).to_contain_text("short.dxf")
    expect(report).to_contain_text(re.compile(r"in the section ENTITIES, after \d+ entities"))
    expect(report).to_contain_text("Send the complete file, or export the drawing again.")
    report.get_by_role("button", name="Close this message").click()
    expect(report).to_be_hidden()


def test_the_report_of_thousands_of_entities_is_listed_in_parts(page: Page) -> None:
    notes = (note(f"No {at}", at % 100, at // 100) for at in range(2500))
    upload_files(page, ("notes.dxf", carton(*notes)))
    page.get_by_test_id("report-dropped").click()
    expect(page.get_by_test_id("entity")).to_have_count(100)
    more = page.get_by_test_id("entities").get_by_test_id("show-more")
    expect(more).to_contain_text("2,400 left")
    more.click()
    expect(page.get_by_test_id("entity")).to_have_count(200)
    page.get_by_test_id("entity").filter(has_text="“No 150”").click()
    expect(page.get_by_test_id("picture")).to_have_attribute("data-pin", "50,1,50,1")


def test_screenshot_of_the_report_for_the_documentation(page: Page, screenshots: Path) -> None:
    upload_files(page, ("carton-as-sent.dxf", customer_file()))
    expect(page.get_by_test_id("drawing-size")).to_contain_text("mm")
    page.set_viewport_size({"width": 1440, "height": 1290})
    for folded in ("Line types", "Layers in the file"):
        page.get_by_role("button", name=folded).first.click()
    page.get_by_text("is a text, which is not cut").click()
    page.get_by_test_id("entity").filter(has_text="Glue here").click()
    expect(page.get_by_test_id("picture")).to_have_attribute("data-pin", "3,100,3,100")
    page.keyboard.press("f")
    page.mouse.move(720, 20)
    page.screenshot(path=screenshots / "import-5-docs.png")


def test_a_dropped_filled_area_is_framed_at_its_position(page: Page, screenshots: Path) -> None:
    corners = ((260.0, 40.0), (340.0, 40.0), (260.0, 90.0), (340.0, 90.0))
    tags = [
        (code + step, value)
        for step, corner in enumerate(corners)
        for code, value in zip((10, 20), corner, strict=True)
    ]
    upload_files(page, ("filled.dxf", carton(text.entity("SOLID", (8, "ART"), *tags))))
    expect(page.get_by_test_id("import-warning")).to_contain_text("is a filled area")
    groups = page.get_by_test_id("report-groups")
    groups.get_by_text("is a filled area without an outline").click()
    page.get_by_test_id("entity").click()
    expect(page.get_by_test_id("picture")).to_have_attribute("data-pin", "260,40,340,90")
    page.screenshot(path=screenshots / "import-6-area.png")


@pytest.mark.long
def test_undo_of_a_reclassification_restores_the_former_rules(page: Page) -> None:
    rule = """title = "Cole"\n[[rule]]\ntype = "crease"\nlayer = ["INNER"]\n"""
    put = """async ([text, version]) => (await fetch("/api/profiles/cole", {
        method: "PUT",
        headers: { "Content-Type": "application/toml", ...(version && { "If-Match": version }) },
        body: text,
    })).status"""
    assert page.evaluate(put, [rule, None]) == 201
    page.reload()
    upload_files(page, ("cole.dxf", carton(text.line(0.0, 150.0, 400.0, 150.0, (8, "INNER")))))
    page.get_by_test_id("profile-select").click()
    page.get_by_role("option", name="Cole").click()
    # The drawing had a crease before, too.
    expect(page.get_by_test_id("profile-select")).to_have_value("Cole")
    expect(page.get_by_test_id("legend-crease")).to_contain_text("1")

    # Another client changes the profile: the drawing keeps the rules it was classified by.
    assert page.evaluate(put, [rule.replace("crease", "half-cut"), '"1"']) == 200
    page.reload()
    page.get_by_test_id("apply-again").click()
    expect(page.get_by_test_id("legend-half-cut")).to_contain_text("1")
    expect(page.get_by_test_id("profile-state")).to_be_hidden()
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("legend-crease")).to_contain_text("1")
    expect(page.get_by_test_id("legend-half-cut")).to_be_hidden()
    expect(page.get_by_test_id("profile-state")).to_contain_text("has changed")
    page.keyboard.press("Control+Shift+z")
    expect(page.get_by_test_id("legend-half-cut")).to_contain_text("1")


def test_a_page_of_a_pdf_is_chosen_by_its_picture(page: Page, screenshots: Path) -> None:
    front = "1 0 0 RG 5 5 80 60 re S 5 35 m 85 35 l S 45 5 m 45 65 l S"
    back = "1 0 0 RG 10 10 m 90 10 l 90 50 l 50 90 l 10 50 l h S 30 30 20 10 re S"
    upload_files(page, ("carton.pdf", pages(front, back, "(damaged")))
    shown = page.get_by_test_id("pages")
    expect(shown.get_by_role("button")).to_have_count(3)
    first, second, third = shown.get_by_role("button").all()
    expect(first).to_have_attribute("aria-current", "true")
    expect(first).to_contain_text("28.2 × 21.2")
    expect(second).to_contain_text("28.2 × 28.2")
    expect(second.locator("img")).to_have_js_property("complete", value=True)
    assert second.locator("img").evaluate("image => image.naturalWidth") > 0
    expect(third).to_be_disabled()
    record_view(page, screenshots / "import-pages-1440.png")
    second.click()
    expect(page.get_by_test_id("drawing-size")).to_have_text(re.compile(r"^28\.2 × 28\.2"))
    expect(second).to_have_attribute("aria-current", "true")
    expect(first).to_be_enabled()
    page.set_viewport_size({"width": 390, "height": 844})
    shown.scroll_into_view_if_needed()
    record_view(page, screenshots / "import-pages-390.png")
