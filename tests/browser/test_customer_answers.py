"""Answers of a customer's drawings on the page: seen, taken back, and given in a table."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.browser.accessibility import record_view
from tests.support.serving.server import square
from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]

#: Widths of the window of a desktop, a tablet and a telephone.
WIDTHS = (1440, 768, 390)


@pytest.fixture
def api(page: Page) -> Iterator[httpx.Client]:
    url = re.sub(r"/(#.*)?$", "", page.url)
    with httpx.Client(base_url=url, timeout=60.0, trust_env=False) as client:
        yield client


def upload(api: httpx.Client, name: str, side: float, *colours: int, customer: str = "") -> str:
    """Upload a square with one free line of each colour, about which questions are asked."""
    free = [
        text.line(20.0, 20.0 + 5 * at, 60.0, 20.0 + 5 * at, (8, "Q7"), (62, colour))
        for at, colour in enumerate(colours)
    ]
    files = {"file": (name, square(side=side, extra=tuple(free)))}
    answer = api.post("/api/drawings", files=files, data={"customer": customer})
    assert answer.status_code == 201, answer.text
    return str(answer.json()["id"])


def open_drawing(page: Page, drawing: str, name: str) -> None:
    page.evaluate("(id) => { location.hash = `#/drawings/${id}/lines` }", drawing)
    expect(page.get_by_role("heading", name=name)).to_be_visible(timeout=60_000)


def in_view(page: Page) -> None:
    """Check that no part of the panels lies beside the window."""
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")


def picture(page: Page, folder: Path, name: str, testid: str) -> None:
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        shown = page.get_by_test_id(testid)
        if shown.is_visible():
            shown.scroll_into_view_if_needed()
        in_view(page)
        record_view(page, folder / f"{name}-{width}.png")
    page.set_viewport_size({"width": 1440, "height": 900})


def test_the_customer_of_a_drawing_answers_its_questions_and_an_answer_is_taken_back(
    page: Page, api: httpx.Client, screenshots: Path
) -> None:
    for at, side in enumerate((100.0, 110.0)):
        taught = upload(api, f"house-{at}.dxf", side, 5, customer="House")
        override = {"overrides": [{"type": "perforation", "edges": [4]}]}
        assert api.patch(f"/api/drawings/{taught}/edges", json=override).status_code == 200
    third = upload(api, "house-2.dxf", 120.0, 5)
    open_drawing(page, third, "house-2.dxf")
    questions, taught_panel = page.get_by_test_id("questions"), page.get_by_test_id("taught")
    expect(questions).to_be_visible()
    expect(taught_panel).to_have_count(0)

    customer = page.get_by_test_id("drawing-customer")
    customer.fill("House")
    customer.press("Enter")
    expect(questions).to_have_count(0)
    expect(page.get_by_test_id("learned-look")).to_contain_text("house-1.dxf, house-0.dxf of House")
    picture(page, screenshots, "customer-learned", "taught")

    page.get_by_test_id("take-back").press("Enter")
    expect(page.get_by_test_id("question")).to_have_count(1)
    expect(page.get_by_test_id("refused-look")).to_be_visible()
    picture(page, screenshots, "customer-refused", "taught")
    page.get_by_test_id("use-again").press("Enter")
    expect(questions).to_have_count(0)
    expect(page.get_by_test_id("learned-look")).to_be_visible()


def test_the_answer_of_one_drawing_is_only_the_most_likely_one(
    page: Page, api: httpx.Client
) -> None:
    first = upload(api, "shop-0.dxf", 100.0, 5, customer="Shop")
    override = {"overrides": [{"type": "perforation", "edges": [4]}]}
    assert api.patch(f"/api/drawings/{first}/edges", json=override).status_code == 200
    open_drawing(page, upload(api, "shop-1.dxf", 110.0, 5, customer="Shop"), "shop-1.dxf")
    question = page.get_by_test_id("question")
    expect(question).to_contain_text("shop-0.dxf")
    expect(question.locator("[data-likely=true]")).to_have_attribute("data-answer", "perforation")


@pytest.mark.long
def test_many_questions_are_a_table_that_is_answered_with_the_keyboard(
    page: Page, api: httpx.Client, screenshots: Path
) -> None:
    colours = (5, 30, 40, 60, 110, 170, 190)
    open_drawing(page, upload(api, "many.dxf", 100.0, *colours), "many.dxf")
    # They are asked one at a time, and all in a table.
    expect(page.get_by_test_id("question")).to_have_count(1)
    expect(page.get_by_text(f"Question 1 of {len(colours)}")).to_be_visible()
    page.get_by_test_id("all-questions").locator("summary").click()
    rows = page.get_by_test_id("question-row")
    expect(rows).to_have_count(len(colours))
    submit = page.get_by_test_id("set-table")
    expect(submit).to_be_disabled()
    first = rows.nth(0).get_by_role("combobox")
    first.focus()
    # The first letters of an option choose it.
    page.keyboard.type("Crease")
    expect(first).to_have_value("crease")
    rows.nth(1).get_by_role("combobox").select_option("ignored")
    expect(submit).to_contain_text(f"2 of {len(colours)} rows")
    picture(page, screenshots, "question-table", "question-table")
    submit.press("Enter")
    # Few questions need no table.
    expect(page.get_by_test_id("question-table")).to_have_count(0)
    page.keyboard.press("Control+z")
    page.get_by_test_id("all-questions").locator("summary").click()
    expect(rows).to_have_count(len(colours))
