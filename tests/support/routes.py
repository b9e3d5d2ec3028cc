"""Routes that the tests of a process prepare once, though they make many applications."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from fastapi import routing
from fastapi.routing import APIRoute


def share_prepared_routes(patch: pytest.MonkeyPatch) -> None:
    """Let all applications of this process use the routes which the first one has prepared.

    FastAPI examines the parameters of each route anew for each application that includes it: 0.4 s
    of CPU time for all of them. The result contains of the application what its tests may replace
    (``dependency_overrides``) only, and no test replaces that.
    """
    # By the identity of the route, which its results keep.
    prepared: dict[int, list[tuple[Any, Any]]] = {}
    original = routing._EffectiveRouteContext.from_api_route

    def from_api_route(*, original_route: APIRoute, include_context: Any) -> Any:
        anywhere = replace(include_context, dependency_overrides_provider=None)
        known = prepared.setdefault(id(original_route), [])
        for included, context in known:
            if included == anywhere:
                return context
        made = original(original_route=original_route, include_context=anywhere)
        known.append((anywhere, made))
        return made

    patch.setattr(routing._EffectiveRouteContext, "from_api_route", from_api_route)
