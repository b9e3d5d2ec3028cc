"""A user accepts shortfalls of a refused job over REST."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from tests.support.serving.server import square, upload_drawing, wait_for_state
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")
#: Two slits in a square; the cutter of the router is 6 mm wide.
SLITS = tuple(text.line(20.0, y, 80.0, y, (8, "CUT")) for y in (40.0, 60.0))
DECISION = {"reason": "the tab is 8 mm wide", "by": "Ada"}


def slit_job(
    client: httpx.Client,
    slits: tuple[str, ...] = SLITS,
    state: str = "refused",
    **fields: object,
) -> dict[str, Any]:
    drawing = upload_drawing(client, square(extra=slits))["id"]
    order = {"drawing": drawing, "machine": "router-table", "board": "greyboard-3.0", **fields}
    answer = client.post("/api/jobs", json=order)
    return wait_for_state(client, answer.json()["id"], state)


def shortfalls(client: httpx.Client, job: dict[str, Any]) -> list[dict[str, Any]]:
    findings = client.get(f"/api/jobs/{job['id']}/verdict").json()["findings"]
    return [one for one in findings if one["severity"] == "shortfall"]


def accept(client: httpx.Client, job: dict[str, Any], *findings: dict[str, Any]) -> httpx.Response:
    chosen = [{"edge": one["edge"], "code": one["code"]} for one in findings]
    return client.post(f"/api/jobs/{job['id']}/exceptions", json={"findings": chosen, **DECISION})


def test_a_job_becomes_ready_when_all_its_shortfalls_are_accepted(client: httpx.Client) -> None:
    job = slit_job(client)
    assert job["actions"] == ["accept"]
    assert job["verdict"]["shortfalls"] == 2
    first, second = shortfalls(client, job)
    partly = accept(client, job, first).json()
    assert (partly["state"], partly["verdict"]["exceptions"]) == ("refused", 1)
    assert "of the slit" in partly["reason"]
    now = accept(client, job, second).json()
    assert (now["state"], now["reason"], now["actions"][0]) == ("ready", "", "release")
    assert (now["verdict"]["accepted"], now["verdict"]["exceptions"]) == (True, 2)
    kept = [one["acceptance"] for one in shortfalls(client, job)]
    assert [(one["by"], one["reason"]) for one in kept] == [("Ada", DECISION["reason"])] * 2
    assert kept[0]["at"] <= kept[1]["at"]
    events = client.get(f"/api/jobs/{job['id']}/events").json()
    assert [(one["who"], one["why"]) for one in events[-2:]] == [
        ("operator Ada", "Ada accepted 1 shortfall: the tab is 8 mm wide")
    ] * 2


def test_an_order_with_release_is_queued_when_its_shortfalls_are_accepted(
    client: httpx.Client,
) -> None:
    job = slit_job(client, release=True)
    assert accept(client, job, *shortfalls(client, job)).json()["state"] == "queued"
    again = accept(client, job, *shortfalls(client, job))
    assert again.status_code == 409
    client.post(f"/api/jobs/{job['id']}/cancel")


def test_what_is_no_shortfall_cannot_be_accepted(client: httpx.Client) -> None:
    job = slit_job(client)
    one, _ = shortfalls(client, job)
    unknown = accept(client, job, one | {"edge": 77})
    assert unknown.status_code == 422
    assert "no finding verify.wide-slit at edge 77" in unknown.text
    for lack in ({"reason": ""}, {"by": ""}):
        body = {"findings": [{"edge": one["edge"], "code": one["code"]}], **DECISION, **lack}
        assert client.post(f"/api/jobs/{job['id']}/exceptions", json=body).status_code == 422
    assert client.get(f"/api/jobs/{job['id']}").json()["state"] == "refused"


def test_a_job_that_could_not_be_compiled_has_nothing_to_accept(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square(side=5000.0))["id"]
    order = {"drawing": drawing, "machine": "router-table", "board": "greyboard-3.0"}
    job = wait_for_state(client, client.post("/api/jobs", json=order).json()["id"], "refused")
    assert job["actions"] == []
    answer = accept(client, job, {"edge": 0, "code": "verify.wide-slit"})
    assert answer.status_code == 409
    assert answer.json()["code"] == "job.no-shortfalls"


def exceptions_of(*findings: dict[str, Any], by: str = "ERP") -> dict[str, Any]:
    chosen = [{"edge": one["edge"], "code": one["code"]} for one in findings]
    return {"findings": chosen, "reason": "as agreed with the customer", "by": by}


def test_an_order_can_accept_shortfalls_in_advance(client: httpx.Client) -> None:
    first, second = shortfalls(client, slit_job(client))
    other = {"edge": 0, "code": "verify.unreached"}
    partly = slit_job(client, exceptions=exceptions_of(first))
    assert (partly["verdict"]["exceptions"], partly["verdict"]["shortfalls"]) == (1, 1)
    assert f"Edge {second['edge']}:" in partly["reason"]
    given = exceptions_of(first, second, other)
    job = slit_job(client, state="queued", release=True, exceptions=given)
    assert (job["verdict"]["accepted"], job["verdict"]["exceptions"]) == (True, 2)
    kept = [one["acceptance"] for one in shortfalls(client, job)]
    assert [(one["by"], one["reason"]) for one in kept] == [
        ("ERP", "as agreed with the customer")
    ] * 2
    events = client.get(f"/api/jobs/{job['id']}/events").json()
    assert ("operator ERP", "ERP accepted 2 shortfalls: as agreed with the customer") in [
        (one["who"], one["why"]) for one in events
    ]
    client.post(f"/api/jobs/{job['id']}/cancel")


def test_exceptions_of_an_order_accept_no_faults(client: httpx.Client) -> None:
    # A square that is larger than the table gives no program and so no verdict.
    drawing = upload_drawing(client, square(side=5000.0))["id"]
    order = {"drawing": drawing, "machine": "router-table", "board": "greyboard-3.0"}
    given = exceptions_of({"edge": 0, "code": "travel.beyond"})
    answer = client.post("/api/jobs", json={**order, "exceptions": given})
    job = wait_for_state(client, answer.json()["id"], "refused")
    assert job["verdict"] is None


def test_shortfalls_of_an_earlier_job_are_listed_and_not_accepted(client: httpx.Client) -> None:
    height = 33.25  # a drawing of this test alone
    slits = tuple(text.line(20.0, y, 80.0, y, (8, "CUT")) for y in (height, 60.0))
    earlier = slit_job(client, slits)
    path = f"/api/jobs/{earlier['id']}/earlier-exceptions"
    assert client.get(path).json() is None
    one, _ = shortfalls(client, earlier)
    accept(client, earlier, one)
    # The same file, uploaded again; one of its two shortfalls was accepted.
    job = slit_job(client, slits)
    assert job["verdict"]["exceptions"] == 0
    found = client.get(f"/api/jobs/{job['id']}/earlier-exceptions").json()
    assert (found["job"], found["created"]) == (earlier["id"], earlier["created"])
    assert [(each["edge"], each["code"]) for each in found["findings"]] == [
        (one["edge"], one["code"])
    ]
    assert found["findings"][0]["acceptance"]["by"] == "Ada"
    accept(client, job, one)
    assert client.get(f"/api/jobs/{job['id']}/earlier-exceptions").json() is None
    # Another board is another job.
    other = slit_job(client, slits, board="greyboard-2.0")
    assert client.get(f"/api/jobs/{other['id']}/earlier-exceptions").json() is None
    assert len(shortfalls(client, other)) == 2
