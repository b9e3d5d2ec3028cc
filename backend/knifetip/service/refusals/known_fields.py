"""Refuse query parameters and body fields that a route does not have.

The names that a route has are those that FastAPI describes in OpenAPI, so they cannot differ from
what is documented.  A route is described at its first request, without its answers: describing the
whole API takes a second, for which the start of the server would have to wait.

``refuse_unknown`` is a dependency of every route; it also refuses empty times and
choices in forms.  Unknown fields of JSON bodies are
refused by the models (``http.models.JsonBody``); this module names the nearest known field.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

from fastapi import Request
from fastapi.exceptions import RequestValidationError
from fastapi.openapi.utils import get_openapi
from fastapi.routing import APIRoute

from knifetip.errors import UnsupportedMedia

#: Media type of forms.
FORM: Final = "multipart/form-data"
_JSON: Final = "application/json"


#: Operations that have been requested, by endpoint; None for one that is not described.
_known: Final[dict[Callable[..., Any], OperationFields | None]] = {}


@dataclass(frozen=True, slots=True)
class OperationFields:
    """Names of the query parameters, and schemas of the body, of an operation."""

    query: tuple[str, ...]
    bodies: tuple[Mapping[str, Any], ...]  #: schemas of the body, one for each media type
    #: Schemas of the parts of a multipart form by name; None if the body is no form.
    form: Mapping[str, Mapping[str, Any]] | None
    media: tuple[str, ...] = ()  #: media types of the body
    #: Schemas to which the bodies refer, by name.
    schemas: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    def reads(self, media: str) -> bool:
        """Return whether the body may have a media type; routes of texts accept any."""
        if not set(self.media) <= {_JSON, FORM}:
            return True
        is_json = media == _JSON or (media.startswith("application/") and media.endswith("+json"))
        return media in self.media or (_JSON in self.media and is_json)

    def has_query(self, name: str) -> bool:
        """Return whether a query parameter is known; ``metadata.KEY`` stands for any key."""
        if name in self.query:
            return True
        prefix, dot, key = name.partition(".")
        return bool(dot and key) and f"{prefix}.KEY" in self.query

    def needs_text(self, name: str) -> bool:
        """Return whether a part of the form cannot be empty: a time, a choice or a file.

        FastAPI reads such a part as one that is missing.
        """
        part = (self.form or {}).get(name, {})
        return not part.keys().isdisjoint(("format", "enum", "contentMediaType"))

    @property
    def has_body(self) -> bool:
        """Whether the operation has a body."""
        return bool(self.bodies)

    def near(
        self, place: Sequence[int | str], described: Callable[[], Mapping[str, Any]]
    ) -> Sequence[str]:
        """Return the names that a parameter or field at a place of a request may have.

        Parameters
        ----------
        place
            Location of the parameter or field, such as ``("body", "sheet", "wdith")``.
        described
            Function that returns the OpenAPI description of the whole API.
        """
        if place[:1] == ("query",):
            return self.query
        schemas = self.schemas
        # A route that describes its body by itself names schemas of the whole description.
        if any(_reference(body) not in ("", *schemas) for body in self.bodies):
            schemas = described()["components"]["schemas"]
        parts: list[Any] = [_resolve_reference(body, schemas) for body in self.bodies]
        for step in place[1:-1]:
            parts = [inner for part in parts for inner in _inner(part, step, schemas)]
        return [name for part in parts for name in part.get("properties", {})]


def operation_of(request: Request) -> OperationFields | None:
    """Return the operation of a request, None if its route is not described."""
    route = request.scope.get("route")
    if not isinstance(route, APIRoute):
        return None
    if route.endpoint not in _known:
        _known[route.endpoint] = describe_fields(route)
    return _known[route.endpoint]


def describe_fields(route: APIRoute) -> OperationFields | None:
    """Return the parameters and fields of a route, None if it is not described."""
    request_only = copy.copy(route)
    request_only.response_field = request_only.stream_item_field = None
    request_only.response_fields = {}
    described = get_openapi(title="", version="", routes=[request_only])
    schemas = described.get("components", {}).get("schemas", {})
    for path in described["paths"].values():
        for operation in path.values():
            return _operation(operation, schemas)
    return None


def _operation(operation: Mapping[str, Any], schemas: Mapping[str, Any]) -> OperationFields:
    content = operation.get("requestBody", {}).get("content", {})
    bodies = [media["schema"] for media in content.values() if "schema" in media]
    form = content.get(FORM)
    return OperationFields(
        tuple(one["name"] for one in operation.get("parameters", []) if one["in"] == "query"),
        tuple(bodies),
        None if form is None else _resolve_reference(form["schema"], schemas).get("properties", {}),
        tuple(content),
        schemas,
    )


def _resolve_reference(schema: Mapping[str, Any], schemas: Mapping[str, Any]) -> Mapping[str, Any]:
    name = _reference(schema)
    return schemas[name] if name else schema


def _reference(schema: Mapping[str, Any]) -> str:
    """Return the name of the schema to which a schema refers, "" if it is written out."""
    name: str = schema.get("$ref", "").rpartition("/")[2]
    return name


def _inner(
    part: Mapping[str, Any], step: int | str, schemas: Mapping[str, Any]
) -> Iterator[Mapping[str, Any]]:
    """Yield the schemas of a property or of the items of a schema."""
    found = part.get("items") if isinstance(step, int) else part.get("properties", {}).get(step)
    for schema in () if found is None else found.get("anyOf", [found]):
        yield _resolve_reference(schema, schemas)


async def refuse_unknown(request: Request) -> None:
    """Raise the error of an invalid request if it has unknown parameters or fields.

    Raises
    ------
    UnsupportedMedia
        The body has another media type than those of the operation.
    RequestValidationError
        The query, the form or the body of an operation without a body has an unknown name.
    """
    operation = operation_of(request)
    if operation is None:
        return
    media = media_of(request)
    if operation.has_body and not operation.reads(media) and _has_content(request):
        raise wrong_media(media, operation.media)
    unknown = [("query", name) for name in request.query_params if not operation.has_query(name)]
    empty: list[tuple[str, str]] = []
    if operation.form is not None and media == FORM:
        # FastAPI has parsed the form; this returns the same one.
        form = await request.form()
        unknown += [("body", name) for name in form if name not in operation.form]
        empty = [("body", name) for name in form if form[name] == "" and operation.needs_text(name)]
    elif not operation.has_body:
        unknown += [("body", name) for name in await _json_fields(request)]
    if unknown or empty:
        await request.close()  # the files of the form
        raise RequestValidationError(
            [{"type": "extra_forbidden", "loc": place, "input": None} for place in unknown]
            + [
                {"type": "string_too_short", "loc": place, "input": "", "ctx": {"min_length": 1}}
                for place in empty
            ]
        )


def wrong_media(media: str, supported: Sequence[str]) -> UnsupportedMedia:
    """Return the error of a body with a media type that is not supported, or without one.

    Parameters
    ----------
    media
        Media type of the body; "" if the request names none.
    supported
        Media types that the operation reads.
    """
    if not media:
        return UnsupportedMedia("request.no-media", supported=supported)
    return UnsupportedMedia("request.wrong-media", media=media[:80], supported=supported)


def names_near(request: Request, place: Sequence[int | str]) -> Sequence[str]:
    """Return the names that a parameter or field at a place of a request may have."""
    operation = operation_of(request)
    return () if operation is None else operation.near(place, request.app.openapi)


def _has_content(request: Request) -> bool:
    """Return whether a request has a body that is not empty."""
    length = request.headers.get("content-length")
    return length != "0" and (length is not None or "transfer-encoding" in request.headers)


def media_of(request: Request) -> str:
    """Return the media type of the body of a request, without parameters; "" if it has none."""
    return request.headers.get("content-type", "").partition(";")[0].strip().lower()


async def _json_fields(request: Request) -> Sequence[str]:
    """Return the names of the fields of a JSON body; clients send an empty object for no body."""
    if media_of(request) != _JSON:
        return ()
    try:
        content = json.loads(await request.body() or b"null")
    except (ValueError, RecursionError):
        return ("",)
    if isinstance(content, dict):
        return tuple(content)
    return () if content is None else ("",)
