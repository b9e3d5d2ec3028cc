"""control_characters: refuse texts with control characters in all parts of a request.

``refuse_control_characters`` is a dependency of every route, so that every database gets the same
texts, and the error names the field.  ``describe_texts`` adds the patterns of these texts to the
REST description.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final, TypeAlias, TypeVar

from fastapi import Request
from fastapi.exceptions import RequestValidationError
from starlette.datastructures import UploadFile

from knifetip.fields import Place, control_characters
from knifetip.messages.characters import TextKind, control_character
from knifetip.service.http.routing import endpoint_of
from knifetip.service.refusals.known_fields import FORM, media_of, operation_of
from knifetip.service.refusals.text_faults import KINDS, control_fault

#: Headers whose values are stored or looked up.
_HEADERS: Final = ("Idempotency-Key", "If-Match", "If-None-Match", "Last-Event-ID")
_ITEMS: Final = "items_with_own_results"
_Schema: TypeAlias = dict[str, Any]
F = TypeVar("F", bound=Callable[..., Any])


def items_with_own_results(field: str) -> Callable[[F], F]:
    """Return a decorator for an endpoint that refuses each item of a list in its body alone.

    The model of the body finds control characters in these items, see ``text_faults``.
    """

    def declare(endpoint: F) -> F:
        vars(endpoint)[_ITEMS] = field
        return endpoint

    return declare


async def refuse_control_characters(request: Request) -> None:
    """Raise the error of an invalid request if one of its texts has a control character.

    Raises
    ------
    RequestValidationError
        A path, query, header, form, file name or JSON text has one.
    """
    faults = [
        control_fault(place, character)
        for place, character in [
            *_characters_in_parameters(request),
            *await _characters_in_body(request),
        ]
    ]
    if faults:
        await request.close()  # the files of the form
        raise RequestValidationError(faults)


def _characters_in_parameters(request: Request) -> Iterator[tuple[Place, str]]:
    path = {name: text for name, text in request.path_params.items() if isinstance(text, str)}
    headers = {name: request.headers.get(name, "") for name in _HEADERS}
    yield from control_characters(path, ("path",), {})
    for name, text in request.query_params.multi_items():
        yield from control_characters({name: text}, ("query",), KINDS)
    yield from control_characters(headers, ("header",), {})


async def _characters_in_body(request: Request) -> list[tuple[Place, str]]:
    operation, media = operation_of(request), media_of(request)
    if operation is not None and operation.form is not None and media == FORM:
        found: list[tuple[Place, str]] = []
        # FastAPI has parsed the form; this returns the same one.
        for name, value in (await request.form()).multi_items():
            if isinstance(value, UploadFile):
                if one := control_character(value.filename or "", TextKind.LINE):
                    found.append((("body", name, "filename"), one))
            else:
                found += control_characters({name: value}, ("body",), KINDS)
        return found
    if media == "application/json" or media.endswith("+json"):
        try:
            content = await request.json()  # parsed once for all
        except (ValueError, RecursionError):
            return []  # the route refuses it
        field = vars(endpoint_of(request.scope)).get(_ITEMS)
        if field is not None and isinstance(content, dict) and isinstance(content.get(field), list):
            content = {**content, field: []}
        return list(control_characters(content, ("body",), KINDS))
    return []


def describe_texts(described: _Schema) -> None:
    """Add the patterns of texts to the parameters and the bodies of requests, in place.

    Schemas of answers are left as they are: older rows may contain such characters.

    Parameters
    ----------
    described
        OpenAPI description.
    """
    schemas = described["components"]["schemas"]
    seen: set[str] = set()
    for item in described["paths"].values():
        for operation in item.values():
            for parameter in operation.get("parameters", ()):
                _add_patterns(parameter.get("schema", {}), TextKind.LINE, schemas, seen)
            for media in operation.get("requestBody", {}).get("content", {}).values():
                _add_patterns(media.get("schema", {}), TextKind.LINE, schemas, seen)


def _add_patterns(schema: _Schema, kind: TextKind, schemas: _Schema, seen: set[str]) -> None:
    """Add the patterns of texts to a schema, in place."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        if name not in seen and not name.endswith("Out"):
            seen.add(name)
            _add_patterns(schemas[name], kind, schemas, seen)
        return
    for branch in (*schema.get("anyOf", ()), *schema.get("oneOf", ()), *schema.get("allOf", ())):
        _add_patterns(branch, kind, schemas, seen)
    for name, part in schema.get("properties", {}).items():
        _add_patterns(part, KINDS.get(name, kind), schemas, seen)
    for key in ("items", "additionalProperties"):
        if isinstance(part := schema.get(key), dict):
            _add_patterns(part, kind, schemas, seen)
    is_free = not any(key in schema for key in ("pattern", "enum", "const", "format"))
    if schema.get("type") == "string" and is_free and not _is_bytes(schema):
        schema["pattern"] = kind.pattern


def _is_bytes(schema: Mapping[str, Any]) -> bool:
    """Return whether a text stands for bytes: a whole file of another format."""
    return "contentMediaType" in schema or "contentEncoding" in schema
