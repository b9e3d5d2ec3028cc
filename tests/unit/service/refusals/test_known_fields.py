"""Parameters and fields that a route does not have are refused, on every route."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import httpx
import pytest
from fastapi.routing import APIRoute, iter_route_contexts

from knifetip.server.app import create_app
from knifetip.service.refusals.known_fields import describe_fields
from tests.support.serving.server import square

pytestmark = pytest.mark.xdist_group("server")

PLACE = ("body", "x")


def faults(answer: httpx.Response) -> list[dict[str, Any]]:
    assert answer.status_code == 422, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    return [
        {"code": fault["code"], **fault["arguments"]}
        for fault in answer.json()["arguments"]["faults"]
    ]


def test_the_names_of_each_route_are_those_of_the_description_of_the_api() -> None:
    app = create_app()
    described = {
        operation["operationId"]: operation
        for path in app.openapi()["paths"].values()
        for operation in path.values()
    }
    schemas = app.openapi()["components"]["schemas"]
    compared = 0
    for context in iter_route_contexts(app.routes):
        route = context.original_route
        if not isinstance(route, APIRoute) or not route.include_in_schema:
            continue
        known = describe_fields(route)
        assert known is not None
        operation = described[route.name.strip("_")]
        parameters = operation.get("parameters", [])
        assert list(known.query) == [one["name"] for one in parameters if one["in"] == "query"]
        content = operation.get("requestBody", {}).get("content", {})
        assert known.media == tuple(content)
        bodies = tuple(one["schema"] for one in content.values() if "schema" in one)
        whole = replace(known, schemas=schemas, bodies=bodies)
        assert list(known.near(PLACE, app.openapi)) == list(whole.near(PLACE, app.openapi))
        compared += 1
    assert compared > 100


def test_every_route_refuses_an_unknown_query_parameter(client: httpx.Client) -> None:
    described = client.get("/api/openapi.json").json()
    served = 0
    for path, operations in described["paths"].items():
        for method, operation in operations.items():
            url = path.replace("{", "").replace("}", "")
            needs_body = operation.get("requestBody", {}).get("required", False)
            if needs_body and method != "get":
                continue  # the missing body is reported first
            answer = client.request(method, url, params={"drawign": "zzz"})
            names = [fault["path"] for fault in faults(answer)]
            assert "query.drawign" in names, (method, path)
            served += 1
    assert served > 40


def test_the_nearest_known_name_is_suggested(client: httpx.Client) -> None:
    answer = client.get("/api/v1/jobs", params={"sate": "done", "limit": 5})
    assert faults(answer) == [{"code": "field.misspelt", "path": "query.sate", "near": "state"}]
    assert answer.json()["source"] == ["query.sate"]
    order = {"drawing": "a", "board": "e-flute", "copy": 3}
    answer = client.post("/api/v1/jobs", json=order)
    assert faults(answer) == [{"code": "field.misspelt", "path": "body.copy", "near": "copies"}]
    nested = {"drawing": "a", "board": "e-flute", "sheet": {"wdith": 3.0, "height": 3.0}}
    assert {"code": "field.misspelt", "path": "body.sheet.wdith", "near": "width"} in faults(
        client.post("/api/v1/jobs", json=nested)
    )
    answer = client.get("/api/v1/jobs", params={"zzzzzz": ""})
    assert faults(answer) == [{"code": "field.unknown", "path": "query.zzzzzz"}]


def test_a_form_has_no_unknown_part(client: httpx.Client) -> None:
    files = {"file": ("a.dxf", square())}
    answer = client.post("/api/v1/drawings", files=files, data={"profil": "default"})
    assert faults(answer) == [{"code": "field.misspelt", "path": "body.profil", "near": "profile"}]
    answer = client.post("/api/v1/drawings", files=files, data={"unit": "mm"})
    assert answer.status_code == 201


@pytest.mark.parametrize(
    ("body", "path"),
    [(b'{"priority": 3}', "body.priority"), (b"[1]", "body."), (b"{", "body.")],
)
def test_a_command_without_a_body_refuses_one(client: httpx.Client, body: bytes, path: str) -> None:
    headers = {"Content-Type": "application/json"}
    answer = client.post("/api/v1/jobs/nothing/release", content=body, headers=headers)
    assert [fault["path"] for fault in faults(answer)] == [path]


@pytest.mark.parametrize("body", [b"", b"{}", b"null"])
def test_an_empty_body_is_no_body(client: httpx.Client, body: bytes) -> None:
    headers = {"Content-Type": "application/json"}
    answer = client.post("/api/v1/jobs/nothing/release", content=body, headers=headers)
    assert answer.status_code == 404


def test_an_upload_is_described_as_binary(client: httpx.Client) -> None:
    schemas = client.get("/api/v1/openapi.json").json()["components"]["schemas"]
    file = schemas["Body_upload_drawing"]["properties"]["file"]
    assert (file["type"], file["format"]) == ("string", "binary")
    assert "contentMediaType" not in file


@pytest.mark.parametrize("name", ["due", "unit"])
def test_a_time_or_a_choice_in_a_form_is_missing_or_has_a_value(
    client: httpx.Client, name: str
) -> None:
    files = {"file": ("a.dxf", square())}
    answer = client.post("/api/v1/drawings", files=files, data={name: ""})
    assert faults(answer) == [{"code": "field.too-short", "path": f"body.{name}", "least": 1}]
    texts = {"profile": "", "notes": "", "customer": "", "external_id": "", "metadata": ""}
    assert client.post("/api/v1/drawings", files=files, data=texts).status_code == 201
