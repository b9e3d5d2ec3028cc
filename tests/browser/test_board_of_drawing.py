"""The board belongs to the drawing: it is not taken over from the one that was open before."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import httpx
import pytest
from playwright.sync_api import Page, expect

from tests.support.writers import dxf_text as text

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("drawings"),
    pytest.mark.timeout(600),
]

E_FLUTE, BOXBOARD = "Corrugated, E-flute 1.6 mm", "Folding boxboard 0.4 mm"


@pytest.fixture
def api(page: Page) -> Iterator[httpx.Client]:
    url = re.sub(r"/(#.*)?$", "", page.url)
    with httpx.Client(base_url=url, timeout=60.0, trust_env=False) as client:
        yield client


def upload(api: httpx.Client, name: str, width: float, **details: str) -> str:
    corners = ((0.0, 0.0), (width, 0.0), (width, 200.0), (0.0, 200.0), (0.0, 0.0))
    content = text.dxf(*(text.line(*a, *b, (8, "CUT")) for a, b in pairwise(corners)))
    answer = api.post("/api/drawings", files={"file": (name, content)}, data=details)
    assert answer.status_code == 201, answer.text
    return str(answer.json()["id"])


def open_drawing(page: Page, drawing: str, name: str) -> None:
    page.evaluate("(id) => { location.hash = `#/drawings/${id}/sheet` }", drawing)
    expect(page.get_by_role("heading", name=name)).to_be_visible(timeout=60_000)


def choose(page: Page, board: str) -> None:
    page.get_by_test_id("board-select").click()
    page.get_by_role("option", name=board).click()


def expect_no_board(page: Page) -> None:
    expect(page.get_by_test_id("board-select")).to_have_value("")
    expect(page.get_by_test_id("compile")).to_be_hidden()
    expect(page.get_by_test_id("choose-board")).to_have_text("Choose the board")


def test_the_board_is_not_taken_over_from_another_drawing(page: Page, api: httpx.Client) -> None:
    first, second = upload(api, "first.dxf", 200.0), upload(api, "second.dxf", 210.0)
    board, prepare = page.get_by_test_id("board-select"), page.get_by_test_id("compile")
    open_drawing(page, first, "first.dxf")
    expect_no_board(page)
    choose(page, E_FLUTE)
    expect(prepare).to_be_enabled()
    open_drawing(page, second, "second.dxf")
    expect_no_board(page)
    choose(page, BOXBOARD)
    open_drawing(page, first, "first.dxf")
    expect(board).to_have_value(E_FLUTE)
    open_drawing(page, second, "second.dxf")
    expect(board).to_have_value(BOXBOARD)
    # A page that was loaded again knows nothing of a board with which no job was made.
    page.reload()
    expect_no_board(page)


@pytest.mark.long
def test_the_board_of_the_last_job_of_a_drawing_is_remembered(
    page: Page, api: httpx.Client
) -> None:
    first, second = upload(api, "first.dxf", 220.0), upload(api, "second.dxf", 230.0)
    order = {"drawing": first, "machine": "demo-table", "board": "e-flute"}
    assert api.post("/api/jobs", json=order).status_code == 201
    open_drawing(page, second, "second.dxf")
    expect_no_board(page)
    open_drawing(page, first, "first.dxf")
    expect(page.get_by_test_id("board-select")).to_have_value(E_FLUTE)
    expect(page.get_by_text("As in the last job of this drawing")).to_be_visible()
    # Each place that names the job names its board.
    page.get_by_test_id("compile").click()
    expect(page.get_by_test_id("job-board")).to_contain_text(E_FLUTE)
    expect(page.get_by_test_id("send")).to_be_visible(timeout=60_000)
    open_drawing(page, second, "second.dxf")
    expect_no_board(page)


def test_the_board_of_the_last_job_of_a_customer_is_offered_and_not_taken(
    page: Page, api: httpx.Client
) -> None:
    drawings = [upload(api, f"{n}.dxf", 240.0 + n, customer="Board & Sons") for n in range(2)]
    order = {"drawing": drawings[0], "machine": "demo-table", "board": "e-flute"}
    answer = api.post("/api/jobs", json={**order, "customer": "Board & Sons"})
    assert answer.status_code == 201
    open_drawing(page, drawings[1], "1.dxf")
    page.get_by_test_id("machine-select").click()
    page.get_by_role("option", name="Demo table 1600 × 1200").click()
    offer = page.get_by_test_id("usual-board")
    expect(offer).to_have_text(f"As last time for Board & Sons: {E_FLUTE}")
    expect_no_board(page)
    offer.click()
    expect(page.get_by_test_id("board-select")).to_have_value(E_FLUTE)
    expect(page.get_by_test_id("compile")).to_be_enabled()
    expect(offer).to_be_hidden()
