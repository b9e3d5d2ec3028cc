"""Routes that declare which scope of access they need (ADR 83).

    router = ScopedRouter(prefix="/jobs")

    @router.get("/{id}")
    @requires(AccessScope.VIEWER)
    def get_job(…): …

A request whose principal has none of the declared scopes is refused before its body is read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cached_property
from typing import Any, Final, NamedTuple, TypeVar

from fastapi import APIRouter, Request
from fastapi.routing import APIRoute, iter_route_contexts
from starlette.datastructures import Headers
from starlette.routing import BaseRoute, compile_path
from starlette.types import Message, Receive, Scope, Send

from knifetip.errors import LibraryError
from knifetip.service.database.acting import DONE, FAILED, REFUSED, ActingPrincipal, acting_as
from knifetip.service.http.answer_language import in_requested_language
from knifetip.service.http.conditional import conditional
from knifetip.service.http.parameters import IDEMPOTENCY_KEY
from knifetip.service.http.principal import (
    Principal,
    PrincipalKind,
    demand,
    missing_scope,
    principal_of,
)
from knifetip.service.http.repeated_requests import answer_once, keeps_keys
from knifetip.service.http.scopes import AccessScope

F = TypeVar("F", bound=Callable[..., Any])

_DECLARED: Final = "needed_scopes"
_UNAUDITED: Final = "unaudited"
_ENDPOINT: Final = "endpoint"
_MACHINES: Final = "/api/machines/"
_SAFE: Final = ("GET", "HEAD", "OPTIONS")


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
    """Declare that every sender may use an endpoint, also one that is not authenticated."""
    return _declaration(())(endpoint)


def unaudited(endpoint: F) -> F:
    """Declare that the audit log gets no entry for accepted requests of an endpoint.

    It is for reports that a program sends several times a second.
    """
    vars(endpoint)[_UNAUDITED] = True
    return endpoint


class ScopedRoute(APIRoute):
    """A route that refuses requests of principals without its scope."""

    @cached_property
    def keeps_answers(self) -> bool:
        """Whether the answers of requests with an Idempotency-Key are kept: of most POST requests.

        Others store the key themselves.  Reports of gateways have no keys, and strangers must not
        fill the disk.
        """
        needed = needed_scopes(self.endpoint)
        is_for_keys = bool(needed) and needed != (AccessScope.GATEWAY,)
        return self.methods == {"POST"} and is_for_keys and not keeps_keys(self)

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or raise ``AccessDenied`` if the scope of its principal is missing.

        A request that is not GET gets an entry in the audit log before its response is sent: in its
        first transaction, or else afterwards.
        """
        if scope["method"] not in (self.methods or ()):
            await super().handle(scope, receive, send)
            return
        scope.setdefault("state", {})[_ENDPOINT] = self.endpoint
        principal = principal_of(Request(scope))
        needed = needed_scopes(self.endpoint)
        acting = _acting(self, scope, principal)
        if scope["method"] in _SAFE:
            acting.audited = False
            if 304 in self.responses:
                send = conditional(scope, send)
            send = in_requested_language(scope, send)
            with acting_as(acting):
                _demand(principal, needed, scope)
                await super().handle(scope, receive, send)
            return
        send = in_requested_language(scope, send)
        outcome = REFUSED if missing_scope(principal, needed) else FAILED
        audited = outcome == REFUSED or not getattr(self.endpoint, _UNAUDITED, False)
        # A stranger, who may sign out, must not fill the disk with entries.
        acting.audited = audited and principal.kind is not PrincipalKind.NONE

        async def send_audited(event: Message) -> None:
            if event["type"] == "http.response.start":
                await _write_entry(scope, acting, acting.outcome or _outcome(event["status"]))
            await send(event)

        try:
            with acting_as(acting):
                _demand(principal, needed, scope)
                if self.keeps_answers and IDEMPOTENCY_KEY in Headers(scope=scope):
                    await answer_once(super().handle, scope, receive, send_audited)
                else:
                    await super().handle(scope, receive, send_audited)
        finally:
            await _write_entry(scope, acting, outcome)


def _demand(principal: Principal, needed: tuple[AccessScope, ...], scope: Scope) -> None:
    """Raise an error if a principal lacks the scope of a request, or may not see its machine."""
    demand(principal, *needed)
    if scope["path"].startswith(_MACHINES):
        name = str(scope.get("path_params", {}).get("name", ""))
        if name and not principal.limits.sees_machine(name):
            known = sorted(principal.limits.machines)
            raise LibraryError("library.unknown", shelf="machine", name=name[:80], known=known)


def endpoint_of(scope: Scope) -> Callable[..., Any] | None:
    """Return the function that has answered a request; None if it was refused before.

    In contrast to ``scope["endpoint"]``, it is found by every middleware: some pass on a copy of
    the scope, but all share its state.
    """
    found: Callable[..., Any] | None = scope["state"].get(_ENDPOINT)
    return found


def _acting(route: APIRoute, scope: Scope, principal: Principal) -> ActingPrincipal:
    """Return the principal of a request with its operation, for events and the audit log."""
    values = [str(value) for value in scope.get("path_params", {}).values()]
    kind = scope["path"].removeprefix("/api/").partition("/")[0].removesuffix("s")
    client = scope.get("client")
    return ActingPrincipal(
        kind=principal.kind.value,
        name=principal.name,
        id=principal.id,
        action=route.name.strip("_"),
        subject_kind=kind,
        subject="/".join(values),
        peer=client[0] if client else "",
        limits=principal.limits,
    )


def _outcome(status: int) -> str:
    return DONE if status < 400 else REFUSED if status < 500 else FAILED


async def _write_entry(scope: Scope, acting: ActingPrincipal, outcome: str) -> None:
    """Write the entry of a request in the audit log, unless it has one or needs none."""
    if acting.audited and not acting.written:
        service = scope["app"].state.service
        await service.threads.reports(service.store.audit.write, acting, outcome)


class ScopedRouter(APIRouter):
    """A router of routes that declare their scopes."""

    def __init__(self, **options: Any) -> None:
        super().__init__(route_class=ScopedRoute, **options)


def needed_scopes(endpoint: Callable[..., Any]) -> tuple[AccessScope, ...]:
    """Return the declared scopes of an endpoint; empty for a public one.

    Raises
    ------
    TypeError
        The endpoint declares no scopes.
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
    keeps_answers: bool = False  #: of requests with an Idempotency-Key


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
        # Without the convertors of parameters, which the description does not have either.
        path = compile_path(context.path or "")[1]
        for method in sorted(context.methods or ()):
            name = route.name.strip("_")
            yield ScopedOperation(method, path, name, needed, route.keeps_answers)


def methods_at(routes: Iterable[BaseRoute], path: str) -> list[str]:
    """Return the methods of all routes that match a path, for the header ``Allow``.

    Starlette writes only the methods of the first matching route into this header.
    """
    found: set[str] = set()
    for context in iter_route_contexts(list(routes)):
        if context.path is not None and compile_path(context.path)[0].match(path):
            found |= set(context.methods or ())
    return sorted({*found, "HEAD"} if "GET" in found else found)
