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


def slit_job(client: httpx.Client, **fields: object) -> dict[str, Any]:
    drawing = upload_drawing(client, square(extra=SLITS))["id"]
    order = {"drawing": drawing, "machine": "router-table", "board": "greyboard-3.0", **fields}
    answer = client.post("/api/jobs", json=order)
    return wait_for_state(client, answer.json()["id"], "refused")


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
    assert "not refused for shortfalls alone" in answer.text
