"""The REST description is true: who needs a key, and which requests are valid."""

from __future__ import annotations

from typing import Any

import httpx
import pytest
from jsonschema_rs import Draft202012Validator

from knifetip.server.app import create_app
from tests.support.serving.server import square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")


def described(client: httpx.Client) -> dict[str, Any]:
    answer: dict[str, Any] = client.get("/api/v1/openapi.json").json()
    return answer


def operations(api: dict[str, Any]) -> list[dict[str, Any]]:
    return [operation for path in api["paths"].values() for operation in path.values()]


def test_a_key_is_optional_for_a_caller_who_needs_none(client: httpx.Client) -> None:
    for operation in operations(described(client)):
        assert not operation["security"] or operation["security"][-1] == {}
    # There was no request yet: keys are needed.
    for operation in operations(create_app().openapi()):
        assert {} not in operation["security"]


@pytest.mark.parametrize(
    ("order", "valid"),
    [
        ({"drawing": "d"}, True),
        ({"file": {"name": "a.dxf", "content": ""}}, True),
        ({"file": {"name": "a.dxf", "content": ""}, "drawing": None}, True),
        ({"file": None, "drawing": "d"}, True),
        ({}, False),
        ({"file": None, "drawing": None}, False),
        ({"file": {"name": "a.dxf", "content": ""}, "drawing": "d"}, False),
    ],
)
def test_an_order_has_exactly_one_drawing(
    client: httpx.Client, order: dict[str, Any], valid: bool
) -> None:
    schemas = described(client)["components"]
    schema = {"$ref": "#/components/schemas/OrderIn", "components": schemas}
    whole = {"board": "e-flute", **order}
    assert Draft202012Validator(schema).is_valid(whole) == valid
    if not valid:
        assert client.post("/api/v1/orders", json=whole).status_code == 422


def test_parts_of_a_form_are_not_null(client: httpx.Client) -> None:
    schemas = described(client)["components"]["schemas"]
    (form,) = (schemas[name] for name in schemas if name.endswith("upload_drawing"))
    for name in ("unit", "due"):
        assert form["properties"][name]["type"] == "string"
        assert name not in form["required"]


def test_unknown_names_in_a_body_have_the_status_of_unknown_ids(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    for changed in ({"board": "no"}, {"machine": "no"}, {"profile": "no"}, {"drawing": "no"}):
        order = {"drawing": drawing, "board": "e-flute", **changed}
        answer = client.post("/api/v1/jobs", json=order)
        assert answer.status_code == 404, changed


def test_message_codes_are_no_enumeration(client: httpx.Client) -> None:
    schema = described(client)["components"]["schemas"]["MessageCode"]
    assert schema["type"] == "string"
    assert "enum" not in schema
    assert "drawing.unknown" in schema["x-known-values"]


def test_an_answer_that_has_not_changed_is_sent_once(client: httpx.Client) -> None:
    upload_drawing(client, square())
    conditional = 0
    for path, item in described(client)["paths"].items():
        operation = item.get("get", {"responses": {}})
        if "304" not in operation["responses"] or "{" in path:
            continue
        conditional += 1
        assert "ETag" in operation["responses"]["200"]["headers"]
        first = client.get(path)
        assert first.status_code == 200, path
        known = {"If-None-Match": f'"other", W/{first.headers["ETag"]}'}
        same = client.get(path, headers=known)
        assert (same.status_code, same.content) == (304, b""), path
        assert same.headers["ETag"] == first.headers["ETag"]
        assert "Content-Type" not in same.headers
        assert client.get(path, headers={"If-None-Match": '"other"'}).content == first.content
    assert conditional >= 6


def test_a_list_with_a_new_entry_is_sent_again(client: httpx.Client) -> None:
    known = {"If-None-Match": client.get("/api/v1/drawings").headers["ETag"]}
    assert client.get("/api/v1/drawings", headers=known).status_code == 304
    drawing = upload_drawing(client, square(side=61.0))["id"]
    changed = client.get("/api/v1/drawings", headers=known)
    assert changed.status_code == 200
    assert changed.json()[0]["id"] == drawing
    assert changed.headers["ETag"] != known["If-None-Match"]
