"""Control characters are refused in every text of a request, and the error names the field."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

import httpx
import pytest

from knifetip.messages.characters import TextKind, control_character
from knifetip.server.app import create_app
from knifetip.service.refusals.text_faults import KINDS

pytestmark = pytest.mark.xdist_group("server")

DESCRIBED: dict[str, Any] = create_app().openapi()
SCHEMAS: dict[str, Any] = DESCRIBED["components"]["schemas"]


def resolved(schema: Mapping[str, Any]) -> Mapping[str, Any]:
    name = schema.get("$ref", "").rpartition("/")[2]
    return SCHEMAS[name] if name else schema


def texts(
    schema: Mapping[str, Any], seen: tuple[str, ...] = ()
) -> Iterator[tuple[Any, tuple[str, ...], Mapping[str, Any]]]:
    """Yield a value with a NUL in one text, the path of the text, and its schema, for each text."""
    name = schema.get("$ref", "")
    if name in seen:
        return
    inside = (*seen, name) if name else seen
    schema = resolved(schema)
    for branch in (*schema.get("anyOf", ()), *schema.get("oneOf", ()), *schema.get("allOf", ())):
        yield from texts(branch, inside)
    for field, part in schema.get("properties", {}).items():
        for value, place, leaf in texts(part, inside):
            yield {field: value}, (field, *place), leaf
    if isinstance(part := schema.get("items"), dict):
        for value, place, leaf in texts(part, inside):
            yield [value], ("0", *place), leaf
    if isinstance(part := schema.get("additionalProperties"), dict):
        yield {"a\0b": 1}, ("ab",), {}
        for value, place, leaf in texts(part, inside):
            yield {"key": value}, ("key", *place), leaf
    if schema.get("type") == "string":
        yield "a\0b", (), schema


def bodies() -> Iterator[Any]:
    for path, item in DESCRIBED["paths"].items():
        for method, operation in item.items():
            content = operation.get("requestBody", {}).get("content", {})
            if (body := content.get("application/json")) is not None:
                yield pytest.param(path, method, body["schema"], id=f"{method} {path}")


def url(path: str) -> str:
    """Return a path with values of its parameters."""
    parts = ("x" if part.startswith("{") else part for part in path.split("/"))
    return "/".join(parts)


@pytest.mark.parametrize(("path", "method", "schema"), list(bodies()))
def test_a_nul_in_any_text_of_a_body_is_refused_with_its_path(
    client: httpx.Client, path: str, method: str, schema: Mapping[str, Any]
) -> None:
    for value, place, _ in texts(schema):
        content = json.dumps(value).encode()
        answer = client.request(
            method, url(path), content=content, headers={"Content-Type": "application/json"}
        )
        where = ".".join(("body", *place))
        if path.endswith("/orders/batch") and place[0] == "orders":
            # Each order has its own result.
            assert answer.status_code == 200, (where, answer.text)
            (result,) = answer.json()
            status, source, text = result["status"], result["source"], result["problem"]["text"]
        else:
            problem = answer.json()
            status, source, text = answer.status_code, problem["source"], problem["text"]
        assert (status, source) == (422, [where])
        assert "U+0000" in text


@pytest.mark.parametrize(("path", "method", "schema"), list(bodies()))
def test_the_description_has_a_pattern_that_excludes_it(
    path: str, method: str, schema: Mapping[str, Any]
) -> None:
    for _, place, leaf in texts(schema):
        assert (
            not leaf or {"pattern", "enum", "const", "format", "contentEncoding"} & leaf.keys()
        ), (path, place)


@pytest.mark.parametrize(
    ("text", "line", "lines", "quoted"),
    [
        ("Müller & Co, 3/4", "", "", ""),
        ("two\nlines\t", "U+000A", "", ""),
        ("bell\a", "U+0007", "U+0007", ""),
        ("delete\x7f", "U+007F", "U+007F", ""),
        ("next line\x85", "U+0085", "U+0085", ""),
        ("half\ud800", "U+D800", "U+D800", "U+D800"),
        ("nul\0", "U+0000", "U+0000", "U+0000"),
        ("right to left \u202e, \u00a0", "", "", ""),
    ],
)
def test_characters_by_kind_of_text(text: str, line: str, lines: str, quoted: str) -> None:
    found = [control_character(text, kind) for kind in TextKind]
    assert found == [line, lines, quoted]


@pytest.mark.parametrize(
    ("body", "place"),
    [
        ({"external_id": "a\nb"}, "body.external_id"),
        ({"customer": "a\x9bb"}, "body.customer"),
        ({"customer": "a\ud800b"}, "body.customer"),
        ({"notes": "a\x7fb"}, "body.notes"),
        ({"metadata": {"key": "a\x01"}}, "body.metadata.key"),
        ({"metadata": {"k\ney": "a"}}, "body.metadata.k\ney"),
    ],
)
def test_fields_of_an_order(client: httpx.Client, body: dict[str, Any], place: str) -> None:
    headers = {"Content-Type": "application/json"}
    answer = client.post("/api/jobs", content=json.dumps(body).encode(), headers=headers)
    assert (answer.status_code, answer.json()["source"]) == (422, [place])


def test_notes_may_have_several_lines(client: httpx.Client) -> None:
    assert KINDS["notes"] is TextKind.LINES
    answer = client.post("/api/jobs", json={"notes": "two\n\tlines"})
    assert "body.notes" not in answer.json()["source"]


def test_paths_queries_headers_forms_and_file_names(client: httpx.Client) -> None:
    def source(answer: httpx.Response) -> list[str]:
        assert answer.status_code == 422, answer.text
        found: list[str] = answer.json()["source"]
        return found

    assert source(client.get("/api/machines/a%00b/station")) == ["path.name"]
    assert source(client.get("/api/jobs?customer=a%01b")) == ["query.customer"]
    key = [(b"Idempotency-Key", b"a\x85b")]
    assert source(client.post("/api/jobs", json={}, headers=httpx.Headers(key))) == [
        "header.Idempotency-Key"
    ]
    files = {"file": ("a.dxf", b"0\nEOF\n")}
    form = {"customer": "a\0b", "notes": "two\nlines"}
    assert source(client.post("/api/drawings", files=files, data=form)) == ["body.customer"]
    boundary = b'--x\r\nContent-Disposition: form-data; name="file"; filename="a\x01.dxf"\r\n\r\n'
    answer = client.post(
        "/api/drawings",
        content=boundary + b"0\r\n--x--\r\n",
        headers={"Content-Type": "multipart/form-data; boundary=x"},
    )
    assert source(answer) == ["body.file.filename"]
