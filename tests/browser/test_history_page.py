"""Ended jobs, statistics and the life of tools on the page."""

from __future__ import annotations

import re
from collections.abc import Iterator

import httpx
import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.conftest import Running
from tests.browser.own_machine import OwnMachine

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("browser"),
    pytest.mark.timeout(600),
]


@pytest.fixture(scope="module")
def machine(server: Running) -> Iterator[OwnMachine]:
    """A machine with one finished job and one that was cancelled while it waited."""
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False, headers=headers) as api:
        machine = OwnMachine(api, "history-table")
        machine.run(copies=2)
        cancelled = machine.order(machine.upload("cancelled-one.dxf"))
        api.post(f"/api/jobs/{cancelled}/cancel").raise_for_status()
        yield machine


@pytest.fixture
def history(page: Page, server: Running, machine: OwnMachine) -> Page:
    page.evaluate("localStorage.setItem('knifetip.operator', 'Mia')")
    page.goto(f"{server.url}/#/history")
    choose(page, "Machine", machine.title)
    return page


def choose(page: Page, field: str, option: str) -> None:
    page.locator(f'input[aria-label="{field}"]').click()
    page.get_by_role("option", name=option, exact=True).click()


def test_ended_jobs_are_found_by_state_board_and_name(history: Page) -> None:
    rows = history.get_by_test_id("history-row")
    expect(rows).to_have_count(2)
    expect(rows.nth(0)).to_contain_text("cancelled-one.dxf")
    expect(rows.nth(1)).to_contain_text("2 copies")
    # A fact about the program that is declared as listed.
    expect(rows.nth(1).get_by_test_id("listed-worked_length")).to_contain_text("Work per copy:")
    expect(rows.nth(1).get_by_test_id("listed-program_bytes")).to_have_count(0)
    choose(history, "State", "Finished")
    expect(rows).to_have_count(1)
    expect(rows).to_contain_text("rigid-box-blank.dxf")
    choose(history, "State", "Cancelled")
    expect(rows).to_contain_text(["cancelled-one.dxf"])
    choose(history, "State", "Interrupted")
    expect(history.get_by_text("No job meets these conditions.")).to_be_visible()
    choose(history, "State", "Finished")
    choose(history, "Board", "Greyboard 1.5 mm")
    expect(rows).to_have_count(0)
    choose(history, "Board", "Greyboard 2.0 mm")
    expect(rows).to_have_count(1)
    history.get_by_test_id("history-drawing").fill("no such drawing")
    expect(rows).to_have_count(0)
    history.get_by_test_id("history-drawing").fill("RIGID")
    expect(rows).to_have_count(1)
    choose(history, "Period", "Last 24 hours")
    expect(rows).to_have_count(1)
    rows.click()
    expect(history).to_have_url(re.compile("/drawings/"))
    expect(history.get_by_test_id("job-state")).to_have_text("Finished")


def test_a_picture_that_a_busy_server_refuses_is_requested_again(
    page: Page, server: Running, machine: OwnMachine
) -> None:
    refused: list[str] = []

    def busy_once(route: Route) -> None:
        if route.request.url in refused:
            route.continue_()
        else:
            refused.append(route.request.url)
            route.fulfill(status=503, headers={"Retry-After": "1", "Cache-Control": "no-store"})

    page.route("**/picture*", busy_once)
    page.goto(f"{server.url}/#/history")
    choose(page, "Machine", machine.title)
    pictures = page.get_by_test_id("history-row").locator("img")
    expect(pictures).to_have_count(2)
    page.wait_for_function(
        """() => [...document.querySelectorAll("[data-testid=history-row] img")]
            .every((one) => one.naturalWidth > 0)"""
    )
    assert refused


def test_statistics_count_jobs_sheets_and_length(history: Page, machine: OwnMachine) -> None:
    history.get_by_text("Statistics", exact=True).click()
    (row,) = machine.api.get(f"/api/statistics?machine={machine.name}&step=month").json()
    shown = history.get_by_test_id("history")
    expect(shown).to_contain_text(machine.title)
    assert row["sheets"] == {"greyboard-2.0": 2}
    expect(shown).to_contain_text("Greyboard 2.0 mm")


def test_a_tool_near_the_end_of_its_life_is_shown_until_it_is_changed(
    history: Page, machine: OwnMachine
) -> None:
    history.get_by_text("Tools", exact=True).click()
    tools = history.get_by_test_id(f"tools-of-{machine.name}")
    used = {
        tool["station"]: tool["used"]
        for tool in machine.api.get(f"/api/machines/{machine.name}/tools").json()
    }
    station = max(used, key=lambda number: used[number])
    assert used[station] > 1.0
    tool = tools.get_by_test_id("tool").nth(sorted(used).index(station))
    expect(tool).to_have_attribute("data-warning", "")
    life = tool.get_by_test_id("tool-life")

    def set_life(metres: float) -> None:
        life.press("ControlOrMeta+a")
        life.press_sequentially(f"{metres:.1f}")
        life.press("Enter")

    set_life(used[station] * 1.05)
    expect(tool).to_have_attribute("data-warning", "near")
    set_life(used[station] * 0.5)
    expect(tool).to_have_attribute("data-warning", "over")
    expect(tool.get_by_role("status")).to_contain_text("hange")
    tool.get_by_test_id("tool-changed").click()
    history.get_by_test_id("confirm-no").click()
    expect(tool).to_have_attribute("data-warning", "over")
    tool.get_by_test_id("tool-changed").click()
    history.get_by_test_id("confirm-yes").click()
    expect(tool).to_have_attribute("data-warning", "")
    expect(tool).to_contain_text("Mia")
    now = machine.api.get(f"/api/machines/{machine.name}/tools").json()
    assert [one["used"] for one in now if one["station"] == station] == [0.0]
