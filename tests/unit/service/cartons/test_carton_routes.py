"""/api/v1/cartons, and orders with a carton instead of a drawing."""

from __future__ import annotations

import uuid
from typing import Any
from xml.etree import ElementTree

import httpx
import pytest
from jsonschema_rs import Draft202012Validator

from knifetip.cartons.registry import STYLES
from tests.support.serving.server import wait_for_state

pytestmark = pytest.mark.xdist_group("server")

MAILER: dict[str, Any] = {"code": "fefco-0427", "length": 200.0, "width": 150.0, "depth": 60.0}
ORDER: dict[str, Any] = {"machine": "demo-table", "board": "b-flute", "carton": MAILER}


def order(client: httpx.Client, key: str = "", **changes: Any) -> httpx.Response:
    headers = {"Idempotency-Key": key} if key else {}
    return client.post("/api/v1/orders", json={**ORDER, **changes}, headers=headers)


def test_styles_have_names_and_schemas_that_their_examples_meet(client: httpx.Client) -> None:
    listed = client.get("/api/v1/cartons").json()
    assert [style["code"] for style in listed] == list(STYLES)
    for style in listed:
        schema = Draft202012Validator(style["parameters"])
        assert schema.is_valid(style["example"])
        assert not schema.is_valid({**style["example"], "length": 0.0})
        assert not schema.is_valid({"length": 100.0})
        assert style["name"]["code"] == f"carton.{style['code']}"
        assert style["name"]["text"]
    boards = {board["name"]: board["material"] for board in client.get("/api/v1/boards").json()}
    assert all(boards[style["board"]] in style["materials"] for style in listed)


@pytest.mark.parametrize("code", STYLES)
def test_each_style_has_a_picture(client: httpx.Client, code: str) -> None:
    answer = client.get(f"/api/v1/cartons/{code}/picture")
    assert (answer.status_code, answer.headers["content-type"]) == (200, "image/svg+xml")
    assert len(ElementTree.fromstring(answer.text)) == 2  # cuts and folds


def test_a_picture_follows_dimensions_options_and_board(client: httpx.Client) -> None:
    address = "/api/v1/cartons/ecma-a20.20/picture"
    queries: list[dict[str, str | float]] = [
        {},
        {"length": 90.0},
        {"length": 90.0, "board": "e-flute"},
        {"options": '{"lids": "straight"}'},
    ]
    pictures = {client.get(address, params=params).text for params in queries}
    assert len(pictures) == 4


@pytest.mark.parametrize(
    ("code", "params", "status", "problem", "source"),
    [
        ("fefco-9999", {}, 404, "library.unknown", []),
        ("fefco-0427", {"board": "tin"}, 404, "library.unknown", []),
        ("fefco-0427", {"depth": 9.0}, 422, "carton.too-small", ["depth"]),
        ("fefco-0427", {"depth": "deep"}, 422, "request.invalid", None),
        ("fefco-0427", {"options": "[]"}, 422, "request.invalid", None),
        ("fefco-0427", {"options": '{"tuk": 3}'}, 422, "request.invalid", None),
        ("fefco-0427", {"options": '{"tuck": 3.0}'}, 422, "request.invalid", None),
    ],
)
def test_wrong_pictures_are_refused(
    client: httpx.Client, code: str, params: dict[str, Any], status: int, problem: str, source: Any
) -> None:
    answer = client.get(f"/api/v1/cartons/{code}/picture", params=params)
    assert (answer.status_code, answer.json()["code"]) == (status, problem), answer.text
    if source is not None:
        assert answer.json()["source"] == source


def test_a_carton_becomes_a_drawing_without_questions_once(client: httpx.Client) -> None:
    headers = {"Idempotency-Key": uuid.uuid4().hex}
    body = {"carton": MAILER, "board": "b-flute", "customer": "Box Ltd"}
    first, again = (client.post("/api/v1/cartons", json=body, headers=headers) for _ in range(2))
    assert (first.status_code, again.status_code) == (201, 201), first.text
    drawing = first.json()
    assert again.json()["id"] == drawing["id"]
    assert first.headers["location"] == f"/api/v1/drawings/{drawing['id']}"
    assert drawing["name"] == "fefco-0427 200x150x60 b-flute.dxf"
    assert (drawing["unit"], drawing["questions"]) == ("mm", [])
    assert drawing["customer"] == "Box Ltd"
    assert {count["type"] for count in drawing["counts"]} == {"cut", "crease"}
    # The blank is longer in thicker board.
    thin = client.post("/api/v1/cartons", json={**body, "board": "e-flute"}).json()
    assert thin["width"] < drawing["width"]
    other = {**body, "carton": {**MAILER, "length": 210.0}}
    reused = client.post("/api/v1/cartons", json=other, headers=headers)
    assert (reused.status_code, reused.json()["code"]) == (422, "request.key-reused")


def test_one_request_orders_a_proven_sample_once(client: httpx.Client) -> None:
    key = uuid.uuid4().hex
    first, again = (order(client, key, external_id="PO-0427") for _ in range(2))
    assert (first.status_code, again.status_code) == (201, 201), first.text
    for part in ("drawing", "job"):
        assert first.json()[part]["id"] == again.json()[part]["id"]
    drawing = first.json()["drawing"]
    assert drawing["name"] == "fefco-0427 200x150x60 b-flute.dxf"
    assert drawing["external_id"] == "PO-0427"
    job = wait_for_state(client, first.json()["job"]["id"], "ready")
    assert job["board"] == "b-flute"
    verdict = client.get(f"/api/v1/jobs/{job['id']}/verdict").json()
    assert verdict["accepted"] is True
    other = order(client, key, external_id="PO-0427", carton={**MAILER, "depth": 61.0})
    assert (other.status_code, other.json()["code"]) == (422, "request.key-reused")


def test_a_batch_draws_cartons_and_reports_impossible_ones(client: httpx.Client) -> None:
    orders = [ORDER, {**ORDER, "carton": {**MAILER, "depth": 9.0}}]
    answer = client.post("/api/v1/orders/batch", json={"orders": orders})
    results = answer.json()
    assert [one["status"] for one in results] == [201, 422], answer.text
    assert results[1]["problem"]["code"] == "carton.too-small"
    assert results[1]["source"] == ["depth"]
    assert results[1]["drawing"] is None


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"drawing": "d1"}, "request.one-drawing"),
        ({"carton": None}, "request.one-drawing"),
        ({"file": {"name": "a.dxf", "content": ""}}, "request.one-drawing"),
        ({"carton": {**MAILER, "code": "fefco-9999"}}, "request.invalid"),
        ({"carton": {**MAILER, "lids": "straight"}}, "request.invalid"),
        ({"carton": {"code": "fefco-0427", "length": 200.0}}, "request.invalid"),
        ({"carton": {**MAILER, "depth": 9.0}}, "carton.too-small"),
    ],
)
def test_wrong_orders_of_cartons_are_refused(
    client: httpx.Client, changes: dict[str, Any], code: str
) -> None:
    answer = order(client, **changes)
    assert (answer.status_code, answer.json()["code"]) == (422, code), answer.text
