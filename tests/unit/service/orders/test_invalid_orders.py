"""An invalid order of a batch has its own result, and the others are placed, on both databases."""

from __future__ import annotations

import json
import uuid
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from knifetip.service.settings import Settings
from tests.support.serving.server import run_server, square, upload_drawing

pytestmark = pytest.mark.xdist_group("invalid-orders")

URL = "/api/v1/orders/batch"
JSON = {"Content-Type": "application/json"}
AT = "body.orders.1"
ORDER: dict[str, Any] = {"board": "e-flute", "machine": "demo-table"}

#: An invalid order by its fault: JSON, in which "DRAWING" is the id of a drawing, the path of the
#: field, and the code of the first fault.
INVALID: dict[str, tuple[str, str, str]] = {
    "NUL in a text": (
        json.dumps({**ORDER, "drawing": "DRAWING", "external_id": "a\0b"}),
        f"{AT}.external_id",
        "field.control-character",
    ),
    "NUL in the key of a value": (
        json.dumps({**ORDER, "drawing": "DRAWING", "metadata": {"a\0b": 1}}),
        f"{AT}.metadata.ab",
        "field.control-character",
    ),
    "NUL in a nested text": (
        json.dumps({**ORDER, "file": {"name": "a\0.dxf", "content": ""}}),
        f"{AT}.file.name",
        "field.control-character",
    ),
    "line break": (
        json.dumps({**ORDER, "drawing": "DRAWING", "customer": "a\nb"}),
        f"{AT}.customer",
        "field.control-character",
    ),
    "half of a character": (
        json.dumps({**ORDER, "drawing": "DRAWING", "customer": "\ud800"}),
        f"{AT}.customer",
        "field.control-character",
    ),
    "type": (
        json.dumps({**ORDER, "drawing": "DRAWING", "copies": "3"}),
        f"{AT}.copies",
        "field.not-whole",
    ),
    "unknown field": (
        json.dumps({**ORDER, "drawing": "DRAWING", "copeis": 3}),
        f"{AT}.copeis",
        "field.misspelt",
    ),
    "missing field": (json.dumps({"drawing": "DRAWING"}), f"{AT}.board", "field.missing"),
    "long text": (
        json.dumps({**ORDER, "drawing": "DRAWING", "customer": "x" * 201}),
        f"{AT}.customer",
        "field.too-long",
    ),
    "large number": (
        json.dumps({**ORDER, "drawing": "DRAWING", "copies": 10**30}),
        f"{AT}.copies",
        "field.above",
    ),
    "no number": (
        json.dumps({**ORDER, "drawing": "DRAWING", "sheet": {"width": float("nan"), "height": 1}}),
        f"{AT}.sheet.width",
        "field.not-a-number",
    ),
    "choice": (
        json.dumps({**ORDER, "drawing": "DRAWING", "lift": "high"}),
        f"{AT}.lift",
        "field.not-one-of",
    ),
    "time": (
        json.dumps({**ORDER, "drawing": "DRAWING", "due": "tomorrow"}),
        f"{AT}.due",
        "field.not-a-time",
    ),
    "many values": (
        json.dumps({**ORDER, "drawing": "DRAWING", "metadata": {str(n): n for n in range(33)}}),
        f"{AT}.metadata",
        "field.too-many",
    ),
    "large values": (
        json.dumps({**ORDER, "drawing": "DRAWING", "metadata": {"a": "x" * 9000}}),
        f"{AT}.metadata",
        "field.metadata-too-large",
    ),
    "two fields that do not agree": (
        json.dumps({**ORDER, "drawing": "DRAWING", "sheet": {"width": 100.0}}),
        f"{AT}.sheet",
        "field.sheet-size",
    ),
    "null": ("null", AT, "field.not-a-table"),
    "text": ('"order"', AT, "field.not-a-table"),
    "list": ("[]", AT, "field.not-a-table"),
}


@pytest.fixture(scope="module", params=["sqlite", "postgresql"])
def shop(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[httpx.Client, str]]:
    """Yield a client of a server with one of the databases, and the id of a drawing."""
    url = f"sqlite:///{tmp_path_factory.mktemp('shop')}/shop.sqlite"
    if request.param == "postgresql":
        url = request.getfixturevalue("postgresql_server")
    with run_server(Settings(database=url, compiles=False)) as client:
        yield client, upload_drawing(client, square())["id"]


@pytest.mark.parametrize("fault", INVALID)
def test_an_invalid_order_is_refused_alone(shop: tuple[httpx.Client, str], fault: str) -> None:
    client, drawing = shop
    invalid, path, code = INVALID[fault]
    run = uuid.uuid4().hex
    good = [
        json.dumps({**ORDER, "drawing": drawing, "customer": run, "external_id": number})
        for number in ("A", "B")
    ]
    first, last = good
    body = f'{{"orders": [{first}, {invalid.replace("DRAWING", drawing)}, {last}]}}'
    headers = {**JSON, "Idempotency-Key": run}
    answer = client.post(URL, content=body, headers=headers)
    assert answer.status_code == 200, answer.text
    results = answer.json()
    assert [one["status"] for one in results] == [201, 422, 201]
    assert [one["job_id"] is None for one in results] == [False, True, False]
    problem = results[1]["problem"]
    assert problem["code"] == "request.invalid"
    assert results[1]["source"] == [path]
    assert problem["arguments"]["faults"][0]["code"] == code
    assert path in problem["text"]

    def stored() -> dict[str, str]:
        rows = client.get("/api/v1/jobs", params={"customer": run}).json()
        return {row["external_id"]: row["id"] for row in rows}

    assert stored() == {"A": results[0]["job_id"], "B": results[2]["job_id"]}
    # Corrected and sent again with the same key, it is placed, and the others are not repeated.
    right = json.dumps({**ORDER, "drawing": drawing, "customer": run, "external_id": "C"})
    again = client.post(
        URL, content=f'{{"orders": [{first}, {right}, {last}]}}', headers=headers
    ).json()
    assert [one["status"] for one in again] == [201, 201, 201]
    assert stored() == {
        "A": results[0]["job_id"],
        "B": results[2]["job_id"],
        "C": again[1]["job_id"],
    }


@pytest.mark.parametrize(
    ("body", "path"),
    [
        ('{"orders": []}', "body.orders"),
        ('{"orders": {"board": "a\\u0000"}}', "body.orders.board"),
        ("{}", "body.orders"),
        ('{"orders": [null], "order": 1}', "body.order"),
        ('{"orders": [null], "a\\u0000": 1}', "body.a"),
        ("[]", "body"),
    ],
)
def test_a_body_without_a_list_of_orders_is_refused(
    shop: tuple[httpx.Client, str], body: str, path: str
) -> None:
    answer = shop[0].post(URL, content=body, headers=JSON)
    assert (answer.status_code, answer.json()["source"]) == (422, [path]), answer.text
