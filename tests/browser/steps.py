"""The steps of a drawing and the places of the page, as a user opens them."""

from __future__ import annotations

from typing import Literal

from playwright.sync_api import Page, expect

Step = Literal["lines", "sheet", "process", "check"]


def go_to(page: Page, step: Step) -> None:
    """Open a step of the open drawing by its link."""
    link = page.get_by_test_id(f"step-{step}")
    link.click()
    expect(link).to_have_attribute("aria-current", "step")


def choose_board(page: Page, board: str) -> None:
    """Choose the board of the next job."""
    go_to(page, "sheet")
    page.get_by_test_id("board-select").click()
    page.get_by_role("option", name=board).click()


def compile_again(page: Page) -> None:
    """Prepare a program of the open drawing once more."""
    go_to(page, "sheet")
    page.get_by_test_id("compile").click()


def open_details(page: Page) -> None:
    """Unfold the figures of the verdict."""
    details = page.get_by_test_id("verdict-details")
    if details.get_attribute("open") is None:
        details.locator("summary").click()
