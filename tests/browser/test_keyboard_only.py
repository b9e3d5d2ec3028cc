"""A designer without a mouse: from the first page to a job in the queue, and a sheet."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from knifetip.service.settings import Settings
from tests.browser.conftest import SIZE, Running
from tests.browser.test_corridor import ODD
from tests.browser.windows import open_window
from tests.support.serving.server import run_server, square, upload_drawing

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(300),
]

#: Most Tab stops from the begin of a step to its main button.
STOPS = 3
#: Whether the focus is seen: by an outline of 2 px, or by a border with the contrast that WCAG
#: 1.4.11 requires.  Of controls without a size, what follows them shows it.
SEEN = """() => {
  const focused = document.activeElement;
  const shown = focused.offsetWidth === 0 && focused.nextElementSibling || focused;
  const style = getComputedStyle(shown);
  if (style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2) return true;
  const luminance = (colour) => {
    const [red, green, blue] = colour.match(/[\\d.]+/g).map(Number).map((value) => value / 255)
      .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const [low, high] = [style.borderTopColor, style.backgroundColor].map(luminance)
    .sort((one, other) => one - other);
  return parseFloat(style.borderTopWidth) > 0 && (high + 0.05) / (low + 0.05) >= 3;
}"""


@pytest.fixture
def empty(browser: Browser, tmp_path: Path, built: None) -> Iterator[Page]:
    """Open the first page of a server without drawings."""
    settings = Settings(database=f"sqlite:///{tmp_path}/empty.sqlite", samples=False)
    with run_server(settings) as client:
        context = open_window(browser, viewport=SIZE, reduced_motion="reduce")
        page = context.new_page()
        page.set_default_timeout(90_000)
        expect.set_options(timeout=90_000)
        page.goto(str(client.base_url))
        yield page
        context.close()


def expect_seen_focus(page: Page) -> None:
    """Assert that the focused control shows that it has the focus."""
    # The border of a field changes its colour in 0.1 s.
    for _ in range(50):
        if page.evaluate(SEEN):
            return
        page.wait_for_timeout(100)
    raise AssertionError(page.evaluate("document.activeElement.outerHTML.slice(0, 300)"))


def tab_to(page: Page, control: Locator, most: int = STOPS, key: str = "Tab") -> None:
    """Move the focus to a control by at most so many Tab stops, each of which is seen."""
    expect(control).to_be_enabled()
    passed: list[str] = []
    for _ in range(most):
        page.keyboard.press(key)
        expect_seen_focus(page)
        if control.evaluate("(element) => element === document.activeElement"):
            return
        passed.append(page.evaluate("document.activeElement.outerHTML.slice(0, 120)"))
    raise AssertionError("\n".join(["The control is not within reach of:", *passed]))


def command(page: Page, words: str) -> None:
    """Run the first command of the palette that is found by some words."""
    page.keyboard.press("Control+k")
    search = page.get_by_test_id("palette")
    expect(search).to_be_focused()
    page.keyboard.type(words)
    expect(search).to_have_value(words)
    page.keyboard.press("Enter")
    expect(search).to_have_count(0)


def choose(page: Page, select: Locator, option: str) -> None:
    """Choose an option of the focused list by arrow keys."""
    expect(select).to_be_focused()
    for _ in range(30):
        page.keyboard.press("ArrowDown")
        chosen = page.locator("[role=option][data-combobox-selected]")
        expect(chosen).to_have_count(1)
        if chosen.inner_text() == option:
            break
    page.keyboard.press("Enter")
    expect(select).to_have_value(option)
    expect(select).to_be_focused()


def main(page: Page, test_id: str) -> Locator:
    """Return the main button of the step, which has an id for each of its actions."""
    return page.locator("[data-main-action]").get_by_test_id(test_id)


def prepare_and_send(page: Page) -> None:
    """From the step Sheet, whose board is asked for, to a job that waits at the machine."""
    tab_to(page, main(page, "choose-board"))
    page.keyboard.press("Enter")
    choose(page, page.get_by_test_id("board-select"), "Folding boxboard 0.4 mm")
    tab_to(page, page.get_by_test_id("machine-select"))
    choose(page, page.get_by_test_id("machine-select"), "Demo table 1600 × 1200")
    # From a field to the main button.
    page.keyboard.press("Control+Enter")
    prepare = main(page, "compile")
    expect(prepare).to_be_focused()
    expect_seen_focus(page)

    # The steps are one stop with arrow keys; the main button is before them.
    sheet, process = page.get_by_test_id("step-sheet"), page.get_by_test_id("step-process")
    tab_to(page, sheet, most=1)
    page.keyboard.press("ArrowRight")
    expect(process).to_be_focused()
    page.keyboard.press("Enter")
    expect(process).to_have_attribute("aria-current", "step")
    tab_to(page, prepare, key="Shift+Tab")
    page.keyboard.press("Enter")

    # The button is disabled meanwhile, and another one takes its place and the focus.
    expect(page.get_by_test_id("step-check")).to_have_attribute("aria-current", "step")
    send = main(page, "send")
    expect(send).to_be_focused()
    command(page, "step lines")
    expect(page.get_by_test_id("step-lines")).to_have_attribute("aria-current", "step")
    command(page, "step check")
    tab_to(page, send)
    page.keyboard.press("Enter")
    expect(main(page, "main-station")).to_be_focused()
    command(page, "machines")
    queue = page.get_by_test_id("queue-of-demo-table")
    expect(queue.get_by_test_id("queue-row")).to_contain_text("Folding boxboard 0.4 mm")


def test_a_sample_becomes_a_job_in_the_queue_by_keys_only(empty: Page) -> None:
    sample = empty.get_by_test_id("sample-tuck-end-carton")
    expect(sample).to_be_visible()
    tab_to(empty, sample)
    empty.keyboard.press("Enter")
    expect(empty.get_by_test_id("board-select")).to_be_visible()
    prepare_and_send(empty)


@pytest.mark.long
def test_questions_of_an_uploaded_file_are_answered_by_keys_only(
    page: Page, tmp_path: Path
) -> None:
    file = tmp_path / "odd.dxf"
    file.write_text(ODD)
    expect(page.get_by_test_id("drawing-row").first).to_be_visible()
    # Chromium is asked for the dialog before the key is pressed.
    with page.expect_file_chooser() as chooser:
        tab_to(page, page.get_by_test_id("choose-file"))
        page.keyboard.press("Enter")
    chooser.value.set_files(file)
    answer = main(page, "answer-first")
    expect(answer).to_have_text("Answer 2 questions")
    tab_to(page, answer)
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("unit-mm")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("answer-cut")).to_be_focused()
    page.keyboard.press("Enter")
    # No question is left: the focus goes on to the main button.
    expect(main(page, "choose-board")).to_be_focused()
    expect(page.get_by_test_id("all-answered")).to_be_visible()
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("board-select")).to_be_focused()


def test_the_palette_keeps_what_is_typed_at_once_after_it_was_closed(page: Page) -> None:
    search = page.get_by_test_id("palette")
    # The page listens to keys as soon as it shows its rail.
    expect(page.get_by_test_id("open-palette")).to_be_visible()
    page.keyboard.press("Control+k")
    expect(search).to_be_focused()
    page.keyboard.type("library")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    expect(search).to_have_value("")
    expect(search).to_be_focused()
    page.keyboard.type("history")
    # Longer than the palette takes to fade out.
    page.wait_for_timeout(400)
    expect(search).to_have_value("history")
    page.keyboard.press("Enter")
    expect(page).to_have_url(re.compile("#/history"))


@pytest.mark.long
def test_drawings_are_placed_moved_turned_and_aligned_by_keys_only(
    page: Page, server: Running
) -> None:
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False) as client:
        first = upload_drawing(client, square())
        other = client.post("/api/drawings", files={"file": ("other.dxf", square(side=60.0))})
        assert other.status_code == 201, other.text
    page.goto(f"{server.url}/#/drawings/{first['id']}/sheet")
    tab_to(page, page.get_by_test_id("lay-out"), most=16)
    page.keyboard.press("Enter")
    copies, placed = page.get_by_test_id("sheet-copy"), page.get_by_test_id("placed")
    expect(copies).to_have_count(1)

    add = page.get_by_test_id("layout-add")
    tab_to(page, add, most=16)
    page.keyboard.type("other.dxf")
    expect(page.get_by_role("option")).to_have_count(1)
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    expect(placed).to_have_count(2)

    # The added drawing is chosen; it is moved and turned on the sheet.
    canvas = page.get_by_test_id("sheet-canvas")
    tab_to(page, canvas, most=16, key="Shift+Tab")
    x, turn = placed.nth(1).get_by_test_id("placed-x"), placed.nth(1).get_by_test_id("placed-turn")
    for _ in range(30):
        page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("ArrowLeft")
    expect(x).to_have_value("299")
    page.keyboard.press("r")
    expect(turn).to_have_value("90")
    page.keyboard.press("Control+z")
    expect(turn).to_have_value("0")

    # Aligned with the other one: both are chosen in the list.
    name = placed.nth(0).get_by_role("button").first
    tab_to(page, name, most=20)
    page.keyboard.press("Shift+Enter")
    expect(name).to_have_attribute("aria-pressed", "true")
    expect(x).to_have_value("299")
    below = page.get_by_test_id("align-below")
    tab_to(page, page.get_by_test_id("align-left"), most=1, key="Shift+Tab")
    for _ in range(2):
        page.keyboard.press("ArrowRight")
    expect(below).to_be_focused()
    page.keyboard.press("Enter")
    y = [one.get_by_test_id("placed-y").input_value() for one in placed.all()]
    assert y[0] == y[1]
    tab_to(page, canvas, most=16, key="Shift+Tab")
    tab_to(page, page.get_by_test_id("layout-order"), most=STOPS, key="Shift+Tab")
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("step-process")).to_have_attribute("aria-current", "step")
