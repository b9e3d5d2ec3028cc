"""Versions of the REST API (ADR 85): requests to ``/api/v1`` are served by the routes of ``/api``.

The routes have paths without a version, ``/api/jobs``.  These paths are an alias of the current
version.  Only this module contains the prefix of a version.
"""

from __future__ import annotations

from typing import Any, Final

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Prefix of the paths of the current version, and of their alias.
VERSIONED: Final = "/api/v1"
ALIAS: Final = "/api"

_KEY: Final = "knifetip.versioned"


class ApiVersion:
    """ASGI middleware that serves ``/api/v1/…`` as ``/api/…``.

    It must be the outermost middleware, so that the access control and the limits see one path for
    each route.  The URLs in the headers ``Location`` and ``Link`` of the response have the prefix
    of the request.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request with the path of its route."""
        if scope["type"] != "http" or not _is_versioned(scope["path"]):
            await self.app(scope, receive, send)
            return
        raw: bytes = scope.get("raw_path") or scope["path"].encode()
        changed = {
            **scope,
            "path": route_path(scope["path"]),
            "raw_path": ALIAS.encode() + raw[len(VERSIONED) :],
            _KEY: True,
        }

        async def send_versioned(event: Message) -> None:
            if event["type"] == "http.response.start":
                headers = MutableHeaders(scope=event)
                for name, before in (("location", ""), ("link", "<")):
                    url = headers.get(name, "")
                    if url.startswith(f"{before}{ALIAS}/"):
                        headers[name] = before + VERSIONED + url[len(before + ALIAS) :]
            await send(event)

        await self.app(changed, receive, send_versioned)


def is_versioned(scope: Scope) -> bool:
    """Return whether a request was sent to a path with a version."""
    return _KEY in scope


def route_path(path: str) -> str:
    """Return the path of the route that answers a path with or without a version."""
    return ALIAS + path[len(VERSIONED) :] if _is_versioned(path) else path


def versioned_path(path: str) -> str:
    """Return the path of a route with the prefix of the version, if it is a route of the API."""
    return VERSIONED + path[len(ALIAS) :] if path.startswith(f"{ALIAS}/") else path


def _is_versioned(path: str) -> bool:
    return path == VERSIONED or path.startswith(f"{VERSIONED}/")


def versioned_paths(described: dict[str, Any]) -> dict[str, Any]:
    """Return an OpenAPI description whose paths of the API have the prefix of the version.

    Parameters
    ----------
    described
        The description with the paths of the routes, such as ``/api/jobs``.
    """
    paths = {versioned_path(path): item for path, item in described["paths"].items()}
    return {**described, "paths": paths}
