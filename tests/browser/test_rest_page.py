"""The rest of an interrupted job on the page: from a contour, from a line, one tool, a copy."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import httpx
import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.conftest import Running
from tests.browser.own_machine import OwnMachine

pytestmark = [
    pytest.mark.browser,
    pytest.mark.xdist_group("browser"),
    pytest.mark.timeout(600),
]


@pytest.fixture(scope="module")
def machine(server: Running) -> Iterator[OwnMachine]:
    headers = {"X-Knifetip": "page"}
    with httpx.Client(base_url=server.url, timeout=60.0, trust_env=False, headers=headers) as api:
        yield OwnMachine(api, "rest-table")


@pytest.fixture
def stopped(machine: OwnMachine) -> Iterator[tuple[str, list[dict[str, Any]]]]:
    """Return a job that was interrupted in its third track, and its tracks."""
    probe = machine.order()
    tracks = machine.api.get(f"/api/jobs/{probe}/tracks").json()
    machine.api.post(f"/api/jobs/{probe}/cancel").raise_for_status()
    job = machine.run("interrupted", line=tracks[2]["first_line"])
    tracks = machine.api.get(f"/api/jobs/{job}/tracks").json()
    assert [track["state"] for track in tracks[:4]] == ["cut", "cut", "begun", "uncut"]
    yield job, tracks
    machine.clear()


@pytest.fixture
def rest(
    page: Page, machine: OwnMachine, server: Running, stopped: tuple[str, list[dict[str, Any]]]
) -> Locator:
    page.goto(f"{server.url}/#/drawings/{machine.drawing}/jobs/{stopped[0]}")
    panel = page.get_by_test_id("rest")
    expect(panel).to_be_visible()
    expect(panel.get_by_test_id("rest-track")).to_have_count(len(stopped[1]))
    return panel


def order(rest: Locator, machine: OwnMachine, stopped: str) -> dict[str, Any]:
    """Order the chosen rest, and return the job that the page opens."""
    page = rest.page
    with page.expect_response(lambda answer: answer.url.endswith("/rest")) as answered:
        rest.get_by_test_id("rest-order").click()
    answer = answered.value
    assert answer.ok, answer.text()
    id = answer.json()["id"]
    expect(page).to_have_url(re.compile(id))
    found = machine.wait(id, "queued")
    assert found["resumes"] == stopped
    return found


def numbers(tracks: list[dict[str, Any]], station: int | None = None) -> list[int]:
    return [track["number"] for track in tracks if station in (None, track["station"])]


def begins_with(machine: OwnMachine, job: str, track: dict[str, Any]) -> bool:
    """Return whether the first track of a job has the edges of another job's track."""
    first = machine.api.get(f"/api/jobs/{job}/tracks").json()[0]
    return bool(first["edges"] == track["edges"] and first["station"] == track["station"])


def test_the_rest_begins_with_the_track_that_was_begun(
    rest: Locator, machine: OwnMachine, stopped: tuple[str, list[dict[str, Any]]]
) -> None:
    job, tracks = stopped
    expect(rest.get_by_test_id("rest-track").nth(2)).to_have_attribute("aria-pressed", "true")
    expect(rest.get_by_test_id("rest-summary")).to_contain_text("begun is made again")
    made = order(rest, machine, job)
    assert begins_with(machine, made["id"], tracks[2])
    left = machine.api.get(f"/api/jobs/{made['id']}/tracks").json()
    assert len(left) == len(tracks) - 2
    assert machine.job(job)["state"] in ("interrupted", "continued")


def test_the_rest_begins_with_a_contour_chosen_in_the_picture(
    rest: Locator, machine: OwnMachine, stopped: tuple[str, list[dict[str, Any]]]
) -> None:
    job, tracks = stopped
    rest.locator('[data-track="2"]').dispatch_event("click")
    expect(rest.get_by_test_id("rest-track").nth(1)).to_have_attribute("aria-pressed", "true")
    expect(rest.get_by_test_id("rest-summary")).to_contain_text("will be made again: 2")
    # Nothing that is not cut is left out, so nothing has to be checked.
    expect(rest.get_by_test_id("rest-made")).to_be_hidden()
    made = order(rest, machine, job)
    assert begins_with(machine, made["id"], tracks[1])


@pytest.mark.long
def test_the_rest_begins_with_a_contour_chosen_in_the_list_after_a_check(
    rest: Locator, machine: OwnMachine, stopped: tuple[str, list[dict[str, Any]]]
) -> None:
    job, tracks = stopped
    rest.get_by_test_id("rest-track").nth(3).click()
    queue = rest.get_by_test_id("rest-order")
    expect(queue).to_be_disabled()
    rest.get_by_test_id("rest-made").check()
    expect(queue).to_be_enabled()
    # Another choice needs another check.
    rest.get_by_test_id("rest-track").nth(3).press("ArrowDown")
    expect(queue).to_be_disabled()
    rest.get_by_test_id("rest-track").nth(4).press("ArrowUp")
    rest.get_by_test_id("rest-made").check()
    made = order(rest, machine, job)
    assert begins_with(machine, made["id"], tracks[3])


@pytest.mark.long
def test_the_rest_begins_with_the_track_of_a_program_line(
    rest: Locator, machine: OwnMachine, stopped: tuple[str, list[dict[str, Any]]]
) -> None:
    job, tracks = stopped
    line = rest.get_by_test_id("rest-line")
    line.fill(str(tracks[1]["last_line"]))
    expect(rest.get_by_test_id("rest-track").nth(1)).to_have_attribute("aria-pressed", "true")
    line.fill(str(tracks[0]["first_line"]))
    expect(rest.get_by_test_id("rest-track").nth(0)).to_have_attribute("aria-pressed", "true")
    made = order(rest, machine, job)
    assert begins_with(machine, made["id"], tracks[0])


@pytest.mark.long
def test_only_one_tool_makes_its_tracks(
    rest: Locator, machine: OwnMachine, stopped: tuple[str, list[dict[str, Any]]]
) -> None:
    job, tracks = stopped
    # The grooves are checked on the sheet; the knife makes all that it has to make.
    station = tracks[-1]["station"]
    first = numbers(tracks, station)[0]
    rest.get_by_test_id("rest-track").nth(first - 1).click()
    rest.get_by_text("Only this tool").click()
    rest.get_by_test_id("rest-made").check()
    made = order(rest, machine, job)
    found = machine.api.get(f"/api/jobs/{made['id']}/tracks").json()
    assert {track["station"] for track in found} == {station}
    assert len(found) == len(numbers(tracks, station)) < len(tracks)


@pytest.mark.long
def test_one_more_copy_needs_a_new_sheet(
    rest: Locator, machine: OwnMachine, stopped: tuple[str, list[dict[str, Any]]]
) -> None:
    job, tracks = stopped
    rest.get_by_text("One more copy").click()
    expect(rest.get_by_test_id("rest-summary")).to_contain_text("Clear the table")
    expect(rest.get_by_test_id("rest-order")).to_have_text("Queue one more copy")
    with rest.page.expect_response(lambda answer: answer.url.endswith("/rest")) as answered:
        rest.get_by_test_id("rest-order").click()
    made = machine.wait(answered.value.json()["id"], "queued")
    found = machine.api.get(f"/api/jobs/{made['id']}/tracks").json()
    assert [track["edges"] for track in found] == [track["edges"] for track in tracks]
    assert machine.job(job)["state"] == "continued"
