from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from tests.support.serving.server import (
    confirm_job,
    order_job,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")

MACHINE = "demo-table"


def claim(client: httpx.Client, gateway: str = "g", wait: float = 0.0) -> httpx.Response:
    return client.post(
        "/api/gateway/claim", json={"gateway": gateway, "machine": MACHINE, "wait": wait}
    )


def beat(client: httpx.Client, job: dict[str, Any], line: int, **more: object) -> httpx.Response:
    fields = {"job": job["job"], "epoch": job["epoch"], "line": line, **more}
    return client.post("/api/gateway/heartbeat", json=fields)


def finish(client: httpx.Client, job: dict[str, Any], outcome: str = "done") -> httpx.Response:
    fields = {"job": job["job"], "epoch": job["epoch"], "outcome": outcome}
    return client.post("/api/gateway/finish", json=fields)


@pytest.fixture
def queued(client: httpx.Client) -> dict[str, Any]:
    drawing = upload_drawing(client, square())["id"]
    return wait_for_state(client, order_job(client, drawing, release=True)["id"], "queued")


@pytest.fixture
def waiting(client: httpx.Client, queued: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Return a job that a gateway has claimed and that waits for the operator."""
    job = claim(client).json()
    assert (job["job"], job["confirm"]) == (queued["id"], True)
    yield job
    match client.get(f"/api/jobs/{job['job']}").json()["state"]:
        case "running" | "held":
            finish(client, job)
        case "queued":
            client.post(f"/api/jobs/{job['job']}/cancel")
        case "interrupted":
            client.post(f"/api/jobs/{job['job']}/scrap")


@pytest.fixture
def claimed(client: httpx.Client, waiting: dict[str, Any]) -> dict[str, Any]:
    """Return a job that is claimed, confirmed and running."""
    assert confirm_job(client, waiting["job"]).status_code == 200
    assert beat(client, waiting, 0, waiting=True).json()["command"] == "start"
    return waiting


def test_a_claim_with_nothing_to_do_waits_and_answers_204(client: httpx.Client) -> None:
    began = time.monotonic()
    assert claim(client, wait=0.5).status_code == 204
    assert 0.4 < time.monotonic() - began < 60.0
    machine = client.get(f"/api/machines/{MACHINE}").json()
    assert (machine["gateway"], machine["job"]) == ("connected", None)


def test_a_claim_brings_the_program_that_was_verified(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    job = client.get(f"/api/jobs/{claimed['job']}").json()
    assert job["state"] == "running"
    assert (claimed["sha256"], claimed["lines"]) == (job["program_sha256"], job["lines"])
    assert claimed["seconds"] == job["verdict"]["seconds"] > 0.0
    program = client.get(claimed["program"])
    assert program.content == client.get(f"/api/jobs/{claimed['job']}/program").content
    assert client.get(f"/api/machines/{MACHINE}").json()["job"] == claimed["job"]


def test_a_second_gateway_gets_nothing_while_the_table_is_taken(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    drawing = upload_drawing(client, square())["id"]
    other = wait_for_state(client, order_job(client, drawing, release=True)["id"], "queued")
    assert claim(client, "another").status_code == 204
    finish(client, claimed, "interrupted")
    assert claim(client, "another").status_code == 204
    client.post(f"/api/jobs/{claimed['job']}/scrap")
    got = claim(client, "another")
    assert got.json()["job"] == other["id"]
    assert finish(client, got.json(), "returned").json()["state"] == "queued"
    client.post(f"/api/jobs/{other['id']}/cancel")


def test_heartbeats_update_the_job_and_return_requested_actions(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    id, lines = claimed["job"], claimed["lines"]
    assert beat(client, claimed, 5, position=[1.0, 2.0, 3.0, 4.0], seconds_left=7.5).json() == {
        "command": "continue",
        "lease": 10.0,
    }
    job = client.get(f"/api/jobs/{id}").json()
    assert (job["line"], job["position"], job["seconds_left"]) == (5, [1.0, 2.0, 3.0, 4.0], 7.5)
    assert job["progress"] == pytest.approx(5 / lines)
    asked = client.post(f"/api/jobs/{id}/hold").json()
    # The former field name remains for clients of earlier versions.
    assert (asked["requested_action"], asked["wish"]) == ("hold", "hold")
    assert beat(client, claimed, 6).json()["command"] == "hold"
    beat(client, claimed, 6, held=True)
    assert client.get(f"/api/jobs/{id}").json()["state"] == "held"
    client.post(f"/api/jobs/{id}/resume", json={"hands_clear": True})
    assert beat(client, claimed, 6, held=True).json()["command"] == "resume"
    beat(client, claimed, 7)
    assert client.get(f"/api/jobs/{id}").json()["state"] == "running"
    client.post(f"/api/jobs/{id}/cancel")
    assert beat(client, claimed, 8).json()["command"] == "cancel"
    assert finish(client, claimed, "cancelled").json()["state"] == "cancelled"


@pytest.mark.parametrize(
    "fields",
    ['"position": [0, 0, NaN, 0]', '"position": [Infinity, 0, 0, 0]', '"seconds_left": NaN'],
)
def test_a_heartbeat_with_an_invalid_number_is_refused(
    client: httpx.Client, claimed: dict[str, Any], fields: str
) -> None:
    body = f'{{"job": "{claimed["job"]}", "epoch": {claimed["epoch"]}, "line": 1, {fields}}}'
    answer = client.post(
        "/api/gateway/heartbeat", content=body, headers={"Content-Type": "application/json"}
    )
    assert answer.status_code == 422
    assert client.get(f"/api/jobs/{claimed['job']}").json()["line"] == 0


def test_a_stale_epoch_is_refused(client: httpx.Client, claimed: dict[str, Any]) -> None:
    old = {**claimed, "epoch": claimed["epoch"] - 1}
    for answer in (beat(client, old, 1), finish(client, old)):
        assert answer.status_code == 409
        assert answer.json()["type"] == "urn:knifetip:problem:stale-epoch"
    finish(client, claimed)
    assert beat(client, claimed, 9).status_code == 409


def test_an_interrupted_job_runs_again_at_the_operators_request(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    assert finish(client, claimed, "interrupted").json()["state"] == "interrupted"
    client.post(f"/api/jobs/{claimed['job']}/requeue")
    again = claim(client).json()
    assert again["job"] == claimed["job"]
    assert again["epoch"] > claimed["epoch"]
    assert client.get(f"/api/jobs/{again['job']}").json()["waiting_for"] == "confirmation"
    assert finish(client, again).json()["state"] == "done"


def test_a_program_is_given_out_only_while_its_job_is_on_a_table(
    client: httpx.Client, queued: dict[str, Any]
) -> None:
    answer = client.get(f"/api/gateway/program/{queued['id']}")
    assert answer.status_code == 409
    assert "is queued" in answer.json()["detail"]
    client.post(f"/api/jobs/{queued['id']}/cancel")


def confirm(client: httpx.Client, job: dict[str, Any], **fields: str) -> httpx.Response:
    return confirm_job(client, job["job"], **fields)


def test_a_claimed_job_waits_for_the_operator_and_states_the_reason(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    assert beat(client, waiting, 0, waiting=True).json()["command"] == "wait"
    job = client.get(f"/api/jobs/{waiting['job']}").json()
    assert (job["state"], job["waiting_for"], job["hint"]) == (
        "queued",
        "confirmation",
        "Check the table, then confirm the job to start it.",
    )
    assert job["reason"] == (
        "The job waits until the operator of Demo table 1600 × 1200 "
        "confirms that the table is clear. Required: board 'Corrugated, E-flute 1.6 mm'. "
        "Tools: Oscillating knife (station 1)."
    )
    assert client.get(f"/api/machines/{MACHINE}").json()["job"] is None
    assert client.get(f"/api/machines/{MACHINE}").json()["gateway"] == "connected"
    # A gateway may download the program before the start.
    assert client.get(waiting["program"]).status_code == 200
    (listed,) = [one for one in client.get("/api/jobs").json() if one["id"] == job["id"]]
    assert listed == job


def test_a_confirmation_with_all_checks_starts_the_job(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    assert confirm_job(client, waiting["job"]).json()["waiting_for"] == "machine"
    assert (
        client.get(f"/api/jobs/{waiting['job']}")
        .json()["reason"]
        .startswith("The operator confirmed")
    )
    assert beat(client, waiting, 0, waiting=True).json()["command"] == "start"
    job = client.get(f"/api/jobs/{waiting['job']}").json()
    assert (job["state"], job["waiting_for"], job["reason"]) == ("running", "", "")


def checks_of(client: httpx.Client, job: str) -> dict[str, str]:
    """Return the texts of the checks before the next start of a job, by their ids."""
    checks = client.get(f"/api/jobs/{job}/confirmation").json()["checks"]
    return {check["id"]: check["text"] for check in checks}


def test_a_confirmation_without_one_of_the_checks_is_refused_and_names_it(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    checks = checks_of(client, waiting["job"])
    assert checks == {
        "board": "The board on the table is Corrugated, E-flute 1.6 mm. It is 1.6 mm thick.",
        "sheet": "A sheet that is larger than the drawing lies in its place. The lower left corner "
        "of the drawing is at X 20, Y 20 mm.",
        "station-1": "Station 1 holds Oscillating knife, and the tool is not damaged.",
        "table-clear": "Nothing lies on the table except the sheet.",
        "hands-clear": "Hands and people are clear of the machine.",
    }
    route = f"/api/jobs/{waiting['job']}/confirm"
    for left_out, text in checks.items():
        refused = client.post(route, json={"checked": [id for id in checks if id != left_out]})
        assert (refused.status_code, refused.json()["code"]) == (409, "job.not-checked")
        assert refused.json()["detail"] == (
            f"The confirmation of job {waiting['job']} leaves out what must be checked at the "
            f"machine: {left_out} ({text})."
        )
    # Without a body, everything is missing.
    assert all(text in client.post(route).json()["detail"] for text in checks.values())
    assert beat(client, waiting, 0, waiting=True).json()["command"] == "wait"


@pytest.mark.parametrize("unknown", ["all", "station-9", ""])
def test_a_check_that_does_not_exist_is_refused_with_those_that_do(
    client: httpx.Client, waiting: dict[str, Any], unknown: str
) -> None:
    checks = [*checks_of(client, waiting["job"]), unknown]
    refused = client.post(f"/api/jobs/{waiting['job']}/confirm", json={"checked": checks})
    assert refused.status_code == 422
    if unknown:
        assert refused.json()["hint"] == (
            "Its checks are board, sheet, station-1, table-clear, hands-clear."
        )
    assert beat(client, waiting, 0, waiting=True).json()["command"] == "wait"


def test_a_repeated_confirmation_needs_its_checks_too(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    assert confirm(client, waiting, colour="red").status_code == 422
    assert confirm(client, waiting, by="Kim").status_code == 200
    assert confirm(client, waiting, by="Kim").status_code == 200
    assert client.post(f"/api/jobs/{waiting['job']}/confirm").status_code == 409


def test_the_events_of_a_job_name_what_was_checked_and_by_whom(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    confirm(client, waiting, by="Kim")
    events = client.get(f"/api/jobs/{waiting['job']}/events").json()
    (checked,) = (event for event in events if event["message"]["code"] == "job.checked")
    assert checked["who"] == "operator Kim"
    for id, text in checks_of(client, waiting["job"]).items():
        assert f"{id} ({text})" in checked["why"]


def test_a_job_that_no_machine_has_taken_cannot_be_confirmed(
    client: httpx.Client, queued: dict[str, Any]
) -> None:
    answer = confirm_job(client, queued["id"])
    assert answer.status_code == 409
    assert "has not claimed it yet" in answer.json()["detail"]
    client.post(f"/api/jobs/{queued['id']}/cancel")


def test_queued_jobs_state_whether_they_wait_for_their_turn_or_for_the_machine(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    drawing = upload_drawing(client, square())["id"]
    following, last = (
        wait_for_state(client, order_job(client, drawing, release=True)["id"], "queued")["id"]
        for _ in range(2)
    )

    def of(id: str) -> tuple[str, str, str]:
        job = client.get(f"/api/jobs/{id}").json()
        return job["waiting_for"], job["reason"], job["hint"]

    title = "Demo table 1600 × 1200"
    taken = f"The job waits, because {title} is occupied by job {claimed['job']}, which is running."
    assert of(following) == ("machine", taken, "")
    assert of(last) == ("turn", taken, "")
    finish(client, claimed, "interrupted")
    waits, reason, hint = of(following)
    assert (waits, reason.endswith("interrupted.")) == ("machine", True)
    assert hint == "Mark that job finished, queue it again or scrap it first."
    client.post(f"/api/jobs/{claimed['job']}/finish")
    assert of(following)[0] == "machine"
    assert "taken by" not in of(following)[1]
    for id in (following, last):
        client.post(f"/api/jobs/{id}/cancel")


def test_a_gateway_that_runs_without_a_confirmation_is_recorded_and_held(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    answer = beat(client, waiting, 1)
    assert (answer.status_code, answer.json()["command"]) == (200, "hold")
    job = client.get(f"/api/jobs/{waiting['job']}").json()
    assert (job["state"], job["waiting_for"]) == ("running", "confirmation")
    assert "the operator has not confirmed" in job["reason"]
    assert (
        client.post(f"/api/jobs/{waiting['job']}/resume", json={"hands_clear": True}).status_code
        == 409
    )
    assert confirm(client, waiting).status_code == 200
    assert beat(client, waiting, 2).json()["command"] == "continue"


def test_a_waiting_job_that_is_cancelled_is_taken_from_its_gateway(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    assert client.post(f"/api/jobs/{waiting['job']}/cancel").json()["state"] == "cancelled"
    assert beat(client, waiting, 0, waiting=True).status_code == 409


def test_the_same_gateway_gets_its_waiting_job_again_and_no_other_does(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    confirm(client, waiting)
    assert claim(client, "another").status_code == 204
    again = claim(client).json()
    assert (again["job"], again["epoch"]) == (waiting["job"], waiting["epoch"] + 1)
    assert beat(client, waiting, 0, waiting=True).status_code == 409
    assert beat(client, again, 0, waiting=True).json()["command"] == "wait"


def test_the_last_owner_reports_late_that_an_interrupted_job_is_done(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    beat(client, claimed, 3)
    fields = {"job": claimed["job"], "epoch": claimed["epoch"], "outcome": "interrupted"}
    end = {"why": "A belt tore.", "line": 5, "line_at_most": 5}
    job = client.post("/api/gateway/finish", json={**fields, **end}).json()
    assert (
        job["reason"]
        == f"The job was interrupted at program line 5 of {claimed['lines']}. A belt tore."
    )
    assert "queue the job again" in job["hint"].lower()
    done = finish(client, claimed).json()
    assert (done["state"], done["line"], done["reason"]) == ("done", claimed["lines"], "")


def test_an_operator_finishes_an_interrupted_job_and_no_other(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    assert client.post(f"/api/jobs/{claimed['job']}/finish").status_code == 409
    finish(client, claimed, "interrupted")
    done = client.post(f"/api/jobs/{claimed['job']}/finish").json()
    assert (done["state"], done["progress"]) == ("done", 1.0)


def interrupted_for(client: httpx.Client, job: dict[str, Any], why: object) -> httpx.Response:
    report = {"job": job["job"], "epoch": job["epoch"], "outcome": "interrupted", "line": 5}
    report["line_at_most"] = 5
    return client.post("/api/gateway/finish", json={**report, "why": why})


def test_a_gateway_reports_a_code_with_arguments(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    alarm = {"code": "grbl.alarm-1", "arguments": {}}
    cause = {
        "code": "controller.alarm",
        "arguments": {"name": "grbl", "code": 1, "alarm": alarm, "due": None},
    }
    job = interrupted_for(client, claimed, {**cause, "text": "t", "hint": "h"}).json()
    interruption = job["message"]["arguments"]["interruption"]
    assert interruption["code"] == "job.interrupted"
    assert interruption["arguments"]["cause"] == cause
    assert job["reason"] == job["message"]["text"]
    assert "grbl stopped with ALARM:1: a limit switch was hit" in job["reason"]
    assert job["hint"] == job["message"]["hint"]
    assert "left. Check the table and home the machine ($H)" in job["hint"]
    event = client.get(f"/api/jobs/{claimed['job']}/events").json()[-1]
    assert event["why"] == job["reason"]
    assert {name: event["message"][name] for name in ("code", "arguments")} == interruption


def test_the_tracks_left_are_a_range_if_the_last_line_is_not_known(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    path = f"/api/jobs/{claimed['job']}"
    left = len(client.get(f"{path}/tracks").json())
    counted = f"{left} track{'s' * (left > 1)} left. "
    report = {"job": claimed["job"], "epoch": claimed["epoch"], "outcome": "interrupted"}
    client.post("/api/gateway/finish", json={**report, "line": 1, "line_at_most": None})
    assert client.get(path).json()["hint"].startswith(f"Continue this sheet, 0 to {counted}")
    client.post("/api/gateway/finish", json={**report, "line": 1, "line_at_most": 1})
    assert client.get(path).json()["hint"].startswith(f"Continue this sheet, {counted}")


def test_a_code_that_the_server_does_not_have_keeps_its_text(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    newer = {"code": "newer.code", "arguments": {"a": 1}, "text": "It rains.", "hint": "Close it."}
    job = interrupted_for(client, claimed, newer).json()
    stored = {"code": "stored.text", "arguments": {"text": "It rains.", "hint": "Close it."}}
    assert job["message"]["arguments"]["interruption"]["arguments"]["cause"] == stored
    assert job["reason"].endswith("It rains.")
    assert "left. Close it. Check the table." in job["hint"]


def test_wrong_arguments_inside_a_message_are_shown_as_they_are(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    cause = {"code": "controller.stopped", "arguments": {"alarm": 9, "axis": "\x1b[31mX"}}
    job = interrupted_for(client, claimed, cause).json()
    assert 'controller.stopped {"alarm": 9, "axis": "\\u001b[31mX"}' in job["reason"]
    (event,) = client.get(f"/api/jobs/{claimed['job']}/events").json()[-1:]
    assert event["why"] == job["reason"]


@pytest.mark.parametrize(
    "why",
    [
        {"code": "gateway.cancelled", "arguments": {"line": "many"}},
        {"code": "job.late-report", "arguments": {"report": {"deep": [{}]}}, "more": 1},
        {"code": "controller.stopped", "arguments": {"error": [], "progress": {}, "height": "x"}},
        {"code": "stored.text", "arguments": {"text": "x" * 30_000, "hint": ""}},
        {"arguments": {}},
        7,
    ],
)
def test_a_malformed_message_is_refused_and_changes_nothing(
    client: httpx.Client, claimed: dict[str, Any], why: object
) -> None:
    before = client.get(f"/api/jobs/{claimed['job']}").json()["state"]
    assert interrupted_for(client, claimed, why).status_code == 422
    assert client.get(f"/api/jobs/{claimed['job']}").json()["state"] == before != "interrupted"
    assert client.get(f"/api/jobs/{claimed['job']}/events").status_code == 200


def test_arguments_that_are_no_messages_are_not_stored(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    wrong = {"code": "controller.not-stopped", "arguments": {"error": [1], "progress": [1]}}
    job = interrupted_for(client, claimed, wrong).json()
    text = 'controller.not-stopped {"error": [1], "progress": [1]}'
    stored = {"code": "stored.text", "arguments": {"text": text, "hint": ""}}
    assert job["message"]["arguments"]["interruption"]["arguments"]["cause"] == stored
    assert client.get(f"/api/jobs/{claimed['job']}/events").status_code == 200


def test_a_job_lists_the_actions_that_are_routes_of_its_own(
    client: httpx.Client, waiting: dict[str, Any]
) -> None:
    job = client.get(f"/api/jobs/{waiting['job']}").json()
    assert job["actions"] == ["confirm", "recompile", "cancel"]
    (listed,) = [row for row in client.get("/api/jobs").json() if row["id"] == job["id"]]
    assert listed["actions"] == job["actions"]
    others = {"hold", "resume", "requeue", "finish", "scrap"}
    for action in others:
        assert client.post(f"/api/jobs/{job['id']}/{action}").status_code == 409
    # The job was released: a repetition of the command changes nothing.
    events = client.get(f"/api/jobs/{job['id']}/events").json()
    assert client.post(f"/api/jobs/{job['id']}/release").status_code == 200
    assert client.get(f"/api/jobs/{job['id']}/events").json() == events


def test_what_the_operator_confirms_is_named(client: httpx.Client, waiting: dict[str, Any]) -> None:
    job = client.get(f"/api/jobs/{waiting['job']}").json()
    confirmation = client.get(f"/api/jobs/{waiting['job']}/confirmation").json()
    assert job["tools"]
    assert confirmation["tools"] == [
        {**tool, "used": use["used"], "life": use["life"] or None, "warning": use["warning"]}
        for tool in job["tools"]
        for use in client.get(f"/api/machines/{MACHINE}/tools").json()
        if use["station"] == tool["station"]
    ]
    machine = client.get(f"/api/machines/{MACHINE}").json()
    assert confirmation["placement"] == machine["origin"]
    assert (confirmation["awaited"], confirmation["board"]) == (True, job["board"])
    assert (confirmation["copy"], confirmation["copies"]) == (1, 1)


def test_a_cancelled_job_names_the_place_where_it_stopped(
    client: httpx.Client, claimed: dict[str, Any]
) -> None:
    assert beat(client, claimed, 3).json()["command"] == "continue"
    client.post(f"/api/jobs/{claimed['job']}/cancel")
    fields = {"job": claimed["job"], "epoch": claimed["epoch"], "outcome": "cancelled", "line": 4}
    fields["line_at_most"] = 6
    place = {"position": [12.5, 30.0, -0.3, 45.0], "station": 1}
    ended = client.post("/api/gateway/finish", json={**fields, **place}).json()
    assert ended["stopped_at"] == {"line": 4, "line_at_most": 6, "certain": False, **place}
