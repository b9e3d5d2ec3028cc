"""The errors of each operation in the REST description, with an example for each code.

``operation_errors.toml`` lists the errors of the operations.  The errors of the layers around them
(access control, limits, storage) follow from method, path and body.  Any error of a drawing file
has the code ``error.in-file``, and any further error of a design the code of its own; both are 422.
"""

from __future__ import annotations

import http
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from knifetip.messages import Message
from knifetip.messages.codes import CODES
from knifetip.service.description.examples import sample_arguments
from knifetip.service.http.models import Problem
from knifetip.service.http.parameters import IDEMPOTENCY_KEY, KEPT_ANSWER
from knifetip.service.http.problems import PROBLEM

_FILE: Final = Path(__file__).with_name("operation_errors.toml")
_ALL: Final[Mapping[int, Sequence[str]]] = {
    400: ("request.no-host",),
    408: ("limit.too-slow",),
    421: ("request.wrong-host",),
    429: ("limit.too-many-requests",),
    500: ("server.internal-error",),
    503: (
        "server.busy",
        "server.database-damaged",
        "server.database-silent",
        "server.stopping",
        "limit.too-many-connections",
    ),
}
_PROTECTED: Final[Mapping[int, Sequence[str]]] = {
    401: ("request.key-needed", "request.wrong-key"),
    403: ("request.scope-missing", "request.local-only"),
    422: ("request.invalid",),
}
_WRITING: Final[Mapping[int, Sequence[str]]] = {
    403: ("request.foreign-page", "request.foreign-origin", "request.not-marked"),
    413: ("request.body-too-large",),
    415: ("request.html-form",),
    422: ("request.not-storable",),
    507: ("limit.disk-low", "limit.disk-full"),
}
_BODY: Final[Mapping[int, Sequence[str]]] = {
    400: ("request.body-unreadable",),
    415: ("request.no-media", "request.wrong-media"),
}
_KEYED: Final[Mapping[int, Sequence[str]]] = {422: ("request.key-reused",)}
_ANSWERED: Final[Mapping[int, Sequence[str]]] = {
    409: ("request.outcome-unknown", "request.secret-not-kept"),
    **_KEYED,
}
_SAFE: Final = ("get", "head")


def document_errors(described: dict[str, Any]) -> None:
    """Add the error responses of all operations, and an example of each code.

    Parameters
    ----------
    described
        The OpenAPI description, which is changed.
    """
    declared = declared_errors()
    examples = described["components"].setdefault("examples", {})
    for path, item in described["paths"].items():
        for method, operation in item.items():
            errors = errors_of(path, method, operation, declared)
            operation["responses"].pop("422", None)
            for status, codes in sorted(errors.items()):
                operation["responses"][str(status)] = _response(status, codes)
                for code in codes:
                    if (key := _key(status, code)) not in examples:
                        examples[key] = _example(status, code)


def declared_errors() -> Mapping[str, Mapping[int, Sequence[str]]]:
    """Return the codes of the errors of operations, by operation and status."""
    table = tomllib.loads(_FILE.read_text(encoding="utf-8"))
    return {
        name: {int(status): codes for status, codes in errors.items()}
        for name, errors in table.items()
    }


def errors_of(
    path: str,
    method: str,
    operation: Mapping[str, Any],
    declared: Mapping[str, Mapping[int, Sequence[str]]],
) -> dict[int, list[str]]:
    """Return the codes of all errors of an operation by status.

    Parameters
    ----------
    path, method
        Path and method (in lower case) of the operation.
    operation
        Its description.
    declared
        The errors of the operations themselves, from ``declared_errors``.
    """
    groups = [_ALL]
    if path.startswith("/api/"):
        groups.append(_PROTECTED)
    if method not in _SAFE:
        groups.append(_WRITING)
    if "requestBody" in operation:
        groups.append(_BODY)
    parameters = operation.get("parameters", ())
    if KEPT_ANSWER in parameters:
        groups.append(_ANSWERED)
    elif any(one["name"] == IDEMPOTENCY_KEY for one in parameters):
        groups.append(_KEYED)
    groups.append(declared.get(operation["operationId"], {}))
    found: dict[int, list[str]] = {}
    for group in groups:
        for status, codes in group.items():
            listed = found.setdefault(status, [])
            listed += [code for code in codes if code not in listed]
    return found


def _response(status: int, codes: Sequence[str]) -> dict[str, Any]:
    listed = ", ".join(f"`{code}`" for code in codes)
    return {
        "description": f"{http.HTTPStatus(status).phrase}: {listed}",
        "content": {
            PROBLEM: {
                "schema": {"$ref": "#/components/schemas/Problem"},
                "examples": {
                    code: {"$ref": f"#/components/examples/{_key(status, code)}"} for code in codes
                },
            }
        },
    }


def _key(status: int, code: str) -> str:
    return f"{code}-{status}"


def _example(status: int, code: str) -> dict[str, Any]:
    message = Message(code, **sample_arguments(CODES[code]))
    problem = Problem.model_validate(
        {
            **message.as_json(),
            "title": http.HTTPStatus(status).phrase,
            "status": status,
        }
    )
    return {"value": problem.model_dump(mode="json")}
