"""The page in German: chosen by the browser or in the settings, with German numbers."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import Running
from tests.browser.steps import go_to
from tests.browser.windows import open_window
from tests.support.serving.server import square

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


@pytest.fixture
def german(browser: Browser, server: Running) -> Iterator[Page]:
    """Open the start page in a browser whose user reads German."""
    context = open_window(browser, locale="de-AT", viewport={"width": 1440, "height": 900})
    page = context.new_page()
    page.goto(server.url)
    yield page
    context.close()


def test_the_page_has_the_language_of_the_browser(german: Page, page: Page) -> None:
    expect(german.get_by_role("heading", name="Arbeit")).to_be_visible()
    assert german.evaluate("document.documentElement.lang") == "de"
    expect(page.get_by_role("heading", name="Work")).to_be_visible()
    assert page.evaluate("document.documentElement.lang") == "en"


def test_a_language_that_is_chosen_in_the_settings_is_remembered(german: Page) -> None:
    german.get_by_test_id("open-settings").click()
    german.get_by_test_id("language-en").click()
    heading = german.get_by_role("heading", name="Settings")
    expect(heading).to_be_visible()
    german.reload()
    expect(heading).to_be_visible()


def test_numbers_are_german_and_are_typed_with_a_comma_or_a_point(german: Page) -> None:
    german.set_input_files(
        "[data-testid=file-input]",
        {"name": "square.dxf", "mimeType": "application/dxf", "buffer": square(side=120.0)},
    )
    go_to(german, "lines")
    expect(german.get_by_test_id("drawing-size")).to_contain_text("120,0 × 120,0")
    go_to(german, "sheet")
    german.get_by_test_id("sheet-select").click()
    german.get_by_role("option", name="Auf ein Rechteck zugeschnitten").click()
    width = german.get_by_label("Breite (mm)")
    for typed in ("150,5", "150.5"):
        width.select_text()
        width.press_sequentially(typed)
        width.blur()
        expect(width).to_have_value("150,5")
