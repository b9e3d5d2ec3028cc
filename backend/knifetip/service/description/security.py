"""Security schemes and scopes of the operations in the OpenAPI schema."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final

from knifetip.service.http.routing import ScopedOperation

_SCHEMES: Final = {
    "key": {
        "type": "http",
        "scheme": "bearer",
        "description": "An API key (`kt_...`), or the key with which the server was started. On "
        "the computer of the server no key is needed while no administrator exists.",
    },
    "session": {
        "type": "apiKey",
        "in": "cookie",
        "name": "knifetip-session-8080",
        "description": "Session of a user who has signed in with a browser; the name ends with "
        "the port of the server.",
    },
}


def describe_scopes(described: dict[str, Any], operations: Iterable[ScopedOperation]) -> None:
    """Add the security schemes, and the scopes of each operation, to an OpenAPI schema."""
    described["components"]["securitySchemes"] = _SCHEMES
    for one in operations:
        operation = described["paths"].get(one.path, {}).get(one.method.lower())
        if operation is None:
            continue
        operation["security"] = [
            {scheme: [scope.value]} for scope in one.needed for scheme in _SCHEMES
        ]
        words = " or ".join(f"`{scope.value}`" for scope in one.needed)
        sentence = f"Needs the scope {words}." if words else "Needs no key."
        text = operation.get("description", "")
        operation["description"] = f"{text}\n\n{sentence}".strip()


def with_optional_keys(described: dict[str, Any]) -> dict[str, Any]:
    """Return an OpenAPI description for a caller whose requests need no key.

    That is a program on the computer of the server, while no administrator exists.
    """
    paths = {
        path: {
            method: {**operation, "security": [*operation["security"], {}]}
            if operation.get("security")
            else operation
            for method, operation in item.items()
        }
        for path, item in described["paths"].items()
    }
    return {**described, "paths": paths}
