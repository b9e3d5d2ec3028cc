"""The OpenAPI 3.1 description of the REST API, made from the routes and the message catalogue."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from typing import Any, Final

from fastapi import FastAPI, Request, Response
from fastapi.openapi.utils import get_openapi
from fastapi.responses import JSONResponse

from knifetip.service.description.documented_errors import document_errors
from knifetip.service.description.examples import Examples, name_in
from knifetip.service.description.security import describe_scopes, with_optional_keys
from knifetip.service.description.text_examples import add_text_examples
from knifetip.service.http.api_version import is_versioned, versioned_paths
from knifetip.service.http.conditional import describe_conditions
from knifetip.service.http.message_models import describe_codes
from knifetip.service.http.models import Problem
from knifetip.service.http.parameters import KEPT_ANSWER
from knifetip.service.http.principal import PrincipalKind, principal_of
from knifetip.service.http.problems import TYPE_PATTERN
from knifetip.service.http.routing import ScopedOperation
from knifetip.service.library.definition_files import add_definition_files
from knifetip.service.refusals.control_characters import describe_texts

_JSON: Final = "application/json"
#: Descriptions by the operations of the applications of this process. They take a second each,
#: and processes with several applications, such as tests, have the same operations in all of them.
_descriptions: Final[dict[tuple[ScopedOperation, ...], dict[str, Any]]] = {}


class Description:
    """The OpenAPI description of an application, with the paths of either prefix of the API."""

    def __init__(self, app: FastAPI, operations: Sequence[ScopedOperation]) -> None:
        self._app = app
        self._operations = tuple(operations)

    def alias(self) -> dict[str, Any]:
        """Return the description with the paths of the alias, ``/api/…``."""
        if self._operations not in _descriptions:
            _descriptions[self._operations] = describe(self._app, self._operations)
        return _descriptions[self._operations]

    def describe_version(self) -> dict[str, Any]:
        """Return the description with the paths of the current version, ``/api/v1/…``."""
        return versioned_paths(self.alias())

    async def answer(self, request: Request) -> Response:
        """Return the description with the paths of the prefix that the request has.

        Keys are described as optional to a caller that needs none.
        """
        # Making it takes a second, in which other requests are answered.
        described = await asyncio.to_thread(
            self.describe_version if is_versioned(request.scope) else self.alias
        )
        if principal_of(request).kind is PrincipalKind.LOCAL:
            described = with_optional_keys(described)
        return JSONResponse(described)


def describe(app: FastAPI, operations: Sequence[ScopedOperation]) -> dict[str, Any]:
    """Return the OpenAPI 3.1 schema of an application.

    The schema also describes the error responses of all routes, the codes of all messages, and who
    may send which request.
    """
    described = get_openapi(
        title=app.title,
        version=app.version,
        description=app.description,
        routes=app.routes,
    )
    schemas = described["components"]["schemas"]
    for name in ("HTTPValidationError", "ValidationError"):
        schemas.pop(name, None)
    for name, schema in (
        Problem.model_json_schema(ref_template="#/components/schemas/{model}", mode="serialization")
        .pop("$defs", {})
        .items()
    ):
        schemas.setdefault(name, schema)
    own = Problem.model_json_schema(
        ref_template="#/components/schemas/{model}", mode="serialization"
    )
    own.pop("$defs", None)
    schemas["Problem"] = own
    add_definition_files(schemas)
    describe_codes(schemas)
    _mark_binary(described)
    describe_texts(described)
    _describe_keys(described, operations)
    schemas["Problem"]["properties"]["type"] |= {"pattern": TYPE_PATTERN}
    document_errors(described)
    _add_examples(described)
    describe_conditions(described)
    describe_scopes(described, operations)
    return described


def _describe_keys(described: dict[str, Any], operations: Sequence[ScopedOperation]) -> None:
    """Add ``Idempotency-Key`` to the operations whose answers are kept."""
    for one in operations:
        operation = described["paths"].get(one.path, {}).get(one.method.lower())
        if operation is not None and one.keeps_answers:
            operation.setdefault("parameters", []).append(KEPT_ANSWER)


def _add_examples(described: dict[str, Any]) -> None:
    """Add an example to each request and each answer, except of bytes."""
    examples = Examples(described["components"]["schemas"])
    for path, item in described["paths"].items():
        name = name_in(path)
        for operation in item.values():
            add_text_examples(operation)
            for parameter in operation.get("parameters", ()):
                if name is not None and (parameter["in"], parameter["name"]) == ("path", "name"):
                    parameter["example"] = name
            body = operation.get("requestBody", {}).get("content", {}).get(_JSON)
            if body is not None and "schema" in body:
                body["example"] = examples.request_body(body["schema"])
            for status, response in operation["responses"].items():
                answer = response.get("content", {}).get(_JSON)
                if status.startswith("2") and answer is not None and "schema" in answer:
                    answer["example"] = examples.of_answer(answer["schema"])


def _mark_binary(part: Any) -> None:
    """Describe bytes as ``format: binary``, from which client generators make files.

    FastAPI describes an uploaded file by its media type, as OpenAPI 3.1 permits; the generators
    openapi-python-client and openapi-generator then make a text of it.
    """
    if isinstance(part, dict):
        if part.get("type") == "string" and "contentMediaType" in part:
            del part["contentMediaType"]
            part["format"] = "binary"
        for value in part.values():
            _mark_binary(value)
    elif isinstance(part, list):
        for value in part:
            _mark_binary(value)
