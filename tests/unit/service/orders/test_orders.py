"""One request takes a drawing and makes a job; several orders have a result each."""

from __future__ import annotations

import base64
import json
import uuid
from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

CHOICES: dict[str, Any] = {
    "machine": "demo-table",
    "board": "e-flute",
    "external_id": "PO-9",
    "due": "2030-01-02T03:04:05Z",
    "metadata": {"site": "Graz"},
}


def encoded(content: bytes) -> dict[str, str]:
    return {"name": "tray.dxf", "content": base64.b64encode(content).decode()}


def send_form(client: httpx.Client, order: Any, content: bytes, key: str = "") -> httpx.Response:
    headers = {"Idempotency-Key": key} if key else {}
    files = {"file": ("tray.dxf", content)}
    return client.post(
        "/api/v1/orders", files=files, data={"order": json.dumps(order)}, headers=headers
    )


@pytest.mark.parametrize("form", [True, False])
def test_an_order_with_its_file_becomes_a_job(client: httpx.Client, form: bool) -> None:
    content = square(side=71.0)
    if form:
        answer = send_form(client, CHOICES, content)
    else:
        body = {**CHOICES, "file": encoded(content)}
        answer = client.post("/api/v1/orders", json=body)
    assert answer.status_code == 201, answer.text
    drawing, job = answer.json()["drawing"], answer.json()["job"]
    assert answer.headers["location"] == f"/api/v1/jobs/{job['id']}"
    assert (drawing["name"], drawing["width"]) == ("tray.dxf", 71.0)
    assert job["drawing"] == drawing["id"]
    for row in (drawing, job):
        assert (row["external_id"], row["metadata"]) == ("PO-9", {"site": "Graz"})
    assert client.get(f"/api/v1/drawings/{drawing['id']}/file").content == content
    wait_for_state(client, job["id"], "ready")


def test_an_order_of_a_stored_drawing(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    answer = client.post("/api/v1/orders", json={**CHOICES, "drawing": drawing})
    assert answer.json()["job"]["drawing"] == drawing


def test_an_order_that_is_repeated_with_its_key_is_made_once(client: httpx.Client) -> None:
    key = uuid.uuid4().hex
    first, again = (send_form(client, CHOICES, square(side=72.0), key) for _ in range(2))
    assert (first.status_code, again.status_code) == (201, 201)
    for part in ("drawing", "job"):
        assert first.json()[part]["id"] == again.json()[part]["id"]
    other = send_form(client, {**CHOICES, "copies": 2}, square(side=72.0), key)
    assert (other.status_code, other.json()["code"]) == (422, "request.key-reused")


def test_an_order_with_questions_is_made_when_they_are_answered(client: httpx.Client) -> None:
    key, number = uuid.uuid4().hex, uuid.uuid4().hex
    order = {**CHOICES, "external_id": number}
    content = square(layer="7", side=73.0, units=None)
    refused = send_form(client, order, content, key)
    assert refused.status_code == 409, refused.text
    assert refused.json()["questions"]
    (drawing,) = client.get("/api/v1/drawings", params={"external_id": number}).json()
    url = f"/api/v1/drawings/{drawing['id']}"
    client.patch(url, json={"unit": "mm"})
    client.patch(f"{url}/edges", json={"overrides": [{"layer": "7", "type": "cut"}]})
    made = send_form(client, order, content, key)
    assert made.status_code == 201, made.text
    assert made.json()["drawing"]["id"] == drawing["id"]


@pytest.mark.parametrize(
    ("body", "status", "source"),
    [
        ({}, 422, "body.board"),
        ({"board": "e-flute"}, 422, None),
        ({"board": "e-flute", "drawing": "nothing"}, 404, None),
        ({"board": "e-flute", "drawing": "a", "file": encoded(b"x")}, 422, None),
        ({"board": "e-flute", "file": {"name": "a.dxf", "content": "%%%"}}, 422, None),
        ({"board": "e-flute", "file": encoded(b"no drawing")}, 422, None),
        ({"board": "e-flute", "colour": 3}, 422, "body.colour"),
        ([], 422, "body"),
    ],
)
def test_an_order_that_cannot_be_made_is_a_problem(
    client: httpx.Client, body: Any, status: int, source: str | None
) -> None:
    answer = client.post("/api/v1/orders", json=body)
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    assert source is None or source in answer.json()["source"]


def test_a_form_needs_both_parts_and_no_other(client: httpx.Client) -> None:
    files = {"file": ("a.dxf", square())}
    assert client.post("/api/v1/orders", files=files).json()["source"] == ["body.order"]
    more = {"order": json.dumps(CHOICES), "oder": "x"}
    assert client.post("/api/v1/orders", files=files, data=more).status_code == 422
    assert send_form(client, {"bord": "x"}, square()).json()["source"][0].startswith("body.order")
    other = {"Content-Type": "text/csv"}
    assert client.post("/api/v1/orders", content=b"a", headers=other).status_code == 415


def test_each_order_of_a_batch_has_its_own_result(client: httpx.Client) -> None:
    good = {**CHOICES, "file": encoded(square(side=74.0))}
    orders = [good, {**good, "board": "nothing"}, {**CHOICES, "drawing": "nothing"}, {**CHOICES}]
    headers = {"Idempotency-Key": uuid.uuid4().hex}
    url = "/api/v1/orders/batch"
    answer = client.post(url, json={"orders": orders}, headers=headers)
    assert answer.status_code == 200, answer.text
    results = answer.json()
    assert [result["index"] for result in results] == [0, 1, 2, 3]
    assert [result["job"] is None for result in results] == [False, True, True, True]
    assert results[0]["job"]["external_id"] == "PO-9"
    codes = [result["problem"] and result["problem"]["code"] for result in results]
    assert codes == [None, "library.unknown", "drawing.unknown", "request.one-drawing"]
    again = client.post(url, json={"orders": orders}, headers=headers).json()
    assert again[0]["job"]["id"] == results[0]["job"]["id"]
    assert client.post(url, json={"orders": [good] * 101}).status_code == 422


def test_a_waiting_job_has_a_place_and_no_start_without_a_gateway(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square(side=75.0))["id"]
    jobs = [order_job(client, drawing, machine="v-groove-table")["id"] for _ in range(2)]
    for job in jobs:
        row = wait_for_state(client, job, "ready")
        assert (row["queue_position"], row["estimated_start"], row["no_estimate"]) == (
            None,
            None,
            "",
        )
        client.post(f"/api/v1/jobs/{job}/release")
    rows = [client.get(f"/api/v1/jobs/{job}").json() for job in jobs]
    assert [row["queue_position"] for row in rows] == [1, 2]
    assert [row["no_estimate"] for row in rows] == ["gateway", "gateway"]
    held = client.patch(f"/api/v1/jobs/{jobs[0]}", json={"on_hold": True}).json()
    assert (held["queue_position"], held["no_estimate"]) == (1, "hold")
    claim = {"gateway": "g", "machine": "v-groove-table", "wait": 0.0}
    client.patch(f"/api/v1/jobs/{jobs[1]}", json={"on_hold": True})
    assert client.post("/api/gateway/claim", json=claim).status_code in (200, 204)
    client.patch(f"/api/v1/jobs/{jobs[0]}", json={"on_hold": False})
    first = client.get(f"/api/v1/jobs/{jobs[0]}").json()
    assert (first["queue_position"], first["no_estimate"]) == (1, "")
    assert first["estimated_start"] >= first["updated"]
    for job in jobs:
        client.post(f"/api/v1/jobs/{job}/cancel")


def test_the_examples_of_the_description_are_accepted(client: httpx.Client) -> None:
    paths = client.get("/api/v1/openapi.json").json()["paths"]

    def example(path: str, media: str) -> Any:
        return paths[f"/api/v1/{path}"]["post"]["requestBody"]["content"][media]["example"]

    fields = example("drawings", "multipart/form-data")
    files = {"file": ("tray.dxf", fields.pop("file"))}
    drawing = client.post("/api/v1/drawings", files=files, data=fields).json()
    assert (drawing["width"], drawing["height"], drawing["questions"]) == (100.0, 80.0, [])
    assert drawing["external_id"] == "PO-4711"
    fields = example("orders", "multipart/form-data")
    files = {"file": ("tray.dxf", fields.pop("file"))}
    answer = client.post("/api/v1/orders", files=files, data=fields)
    assert (answer.status_code, answer.json()["job"]["copies"]) == (201, 2)
    media = "application/vnd.cip4-xjdf+xml"
    order = example("xjdf", media)
    unknown = client.post("/api/v1/xjdf", content=order, headers={"Content-Type": media})
    assert (unknown.status_code, unknown.json()["code"]) == (404, "drawing.unknown")
    order = order.replace("/drawings/5p256sc8xs7q", f"/drawings/{drawing['id']}")
    answer = client.post("/api/v1/xjdf", content=order, headers={"Content-Type": media})
    assert (answer.status_code, answer.json()["external_id"]) == (201, "PO-4711")
    media = "application/vnd.cip4-xjmf+xml"
    query = example("xjmf", media)
    answer = client.post("/api/v1/xjmf", content=query, headers={"Content-Type": media})
    assert 'ReturnCode="0"' in answer.text
