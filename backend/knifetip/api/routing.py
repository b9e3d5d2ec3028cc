"""Routes that declare which scope of access they need (ADR 83).

    router = ScopedRouter(prefix="/jobs")

    @router.get("/{id}")
    @requires(AccessScope.VIEWER)
    def get_job(…): …

A request whose principal has none of the declared scopes is refused before its body is read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Final, NamedTuple, TypeVar

from fastapi import APIRouter, Request
from fastapi.routing import APIRoute, iter_route_contexts
from starlette.routing import BaseRoute
from starlette.types import Receive, Scope, Send

from knifetip.api.principal import demand, principal_of
from knifetip.jobs.accounts.scopes import AccessScope

F = TypeVar("F", bound=Callable[..., Any])

_DECLARED: Final = "needed_scopes"


def requires(*scopes: AccessScope) -> Callable[[F], F]:
    """Return a decorator that declares the scopes that an endpoint needs; one of them suffices."""
    if not scopes:
        raise TypeError("requires() without a scope; use @public for a route without one")
    return _declaration(scopes)


def _declaration(scopes: tuple[AccessScope, ...]) -> Callable[[F], F]:
    def declare(endpoint: F) -> F:
        vars(endpoint)[_DECLARED] = scopes
        return endpoint

    return declare


def public(endpoint: F) -> F:
    """Declare that every sender may use an endpoint, also one that has proved nothing."""
    return _declaration(())(endpoint)


class ScopedRoute(APIRoute):
    """A route that refuses requests of principals without its scope."""

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or raise ``AccessDenied`` if the scope of its principal is missing."""
        if scope["method"] in (self.methods or ()):
            demand(principal_of(Request(scope)), *needed_scopes(self.endpoint))
        await super().handle(scope, receive, send)


class ScopedRouter(APIRouter):
    """A router of routes that declare their scopes."""

    def __init__(self, **options: Any) -> None:
        super().__init__(route_class=ScopedRoute, **options)


def needed_scopes(endpoint: Callable[..., Any]) -> tuple[AccessScope, ...]:
    """Return the declared scopes of an endpoint; empty for a public one.

    Raises
    ------
    TypeError
        The endpoint declares nothing.
    """
    declared: tuple[AccessScope, ...] | None = getattr(endpoint, _DECLARED, None)
    if declared is None:
        raise TypeError(
            f"the route of {endpoint.__name__} declares no scope; "
            "decorate it with @requires(...) or @public"
        )
    return declared


class ScopedOperation(NamedTuple):
    """An operation of the API with the scopes of which it needs one; none for a public one."""

    method: str
    path: str
    name: str
    needed: tuple[AccessScope, ...]


def scoped_operations(routes: Iterable[BaseRoute]) -> Iterator[ScopedOperation]:
    """Yield the operations of all API routes of an application with their declared scopes.

    Raises
    ------
    TypeError
        A route declares no scope, or would not check it.
    """
    for context in iter_route_contexts(list(routes)):
        route = context.original_route
        if not isinstance(route, APIRoute):
            continue
        needed = needed_scopes(route.endpoint)
        if not isinstance(route, ScopedRoute):
            raise TypeError(f"the route {context.path} is not in a ScopedRouter")
        for method in sorted(context.methods or ()):
            yield ScopedOperation(method, context.path or "", route.name.strip("_"), needed)
