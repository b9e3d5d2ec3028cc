"""Principals: the senders of requests, with the scopes that permit requests (ADR 83)."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Collection, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Annotated, Any, Final

from fastapi import Depends, Request

from knifetip.errors import AccessDenied
from knifetip.service.database.key_limits import UNLIMITED, KeyLimits
from knifetip.service.http.scopes import (
    ALL_SCOPES,
    AccessScope,
    scopes_of_role,
)


class PrincipalKind(StrEnum):
    """How a principal was authenticated."""

    USER = "user"  #: a user who has signed in
    KEY = "key"  #: an API key
    DEVICE = "device"  #: a browser that was paired with a machine
    LOCAL = "local"  #: a program on this computer, while no administrator exists
    SERVER_KEY = "server-key"  #: the key with which the server was started
    NONE = "none"  #: not authenticated


@dataclass(frozen=True, slots=True)
class Principal:
    """The sender of a request, with its scopes."""

    kind: PrincipalKind
    name: str = ""  #: name of the user, or title of the API key
    id: str = ""  #: id of the user or of the API key; "" for the others
    scopes: frozenset[AccessScope] = frozenset()
    limits: KeyLimits = UNLIMITED  #: of an API key
    binds: bool = False  #: a key of a gateway that is bound to machines, now or at its first use


ANONYMOUS: Final = Principal(PrincipalKind.NONE, "anonymous")
LOCAL: Final = Principal(PrincipalKind.LOCAL, "local", scopes=ALL_SCOPES)
#: People have it in their browsers, so it does not open the routes of gateways.
SERVER_KEY: Final = Principal(
    PrincipalKind.SERVER_KEY, "server key", scopes=scopes_of_role(AccessScope.ADMIN)
)
#: The gateway that runs in the process of the server.
EMBEDDED_GATEWAY: Final = Principal(
    PrincipalKind.KEY, "embedded gateway", scopes=frozenset({AccessScope.GATEWAY})
)


def missing_scope(principal: Principal, needed: Collection[AccessScope]) -> AccessScope | None:
    """Return the scope that a principal lacks for a request; None if it may send the request.

    Parameters
    ----------
    principal
        Sender of the request.
    needed
        Scopes of which one is sufficient; empty for a request that every sender may send.

    Returns
    -------
    The least of the needed scopes: first those that are roles, then the others.
    """
    if not needed or principal.scopes.intersection(needed):
        return None
    return min(needed, key=list(AccessScope).index)


def demand(principal: Principal, *needed: AccessScope) -> None:
    """Raise ``AccessDenied`` if a principal has none of the needed scopes."""
    missing = missing_scope(principal, needed)
    if missing is not None:
        raise AccessDenied(
            "request.scope-missing",
            principal=principal.name,
            scope=missing.value,
            scopes=sorted(principal.scopes),
        )


def demand_all_customers(principal: Principal) -> None:
    """Raise ``AccessDenied`` if a principal may see one customer only: sums show all of them."""
    if principal.limits.customer:
        raise AccessDenied("key.limited", customer=principal.limits.customer)


def principal_of(request: Request) -> Principal:
    """Return the principal of a request, which the access control has found."""
    principal: Principal = request.scope.get("state", {}).get("principal", ANONYMOUS)
    return principal


def bind_to_machine(request: Request, machine: str) -> None:
    """Limit the principal of a request to a machine, to which its key has just been bound."""
    principal = principal_of(request)
    limits = replace(principal.limits, machines=frozenset({machine}))
    request.scope["state"]["principal"] = replace(principal, limits=limits)


def is_refused(scope: Mapping[str, Any]) -> bool:
    """Return whether the access control has refused a request, whose answer may be delayed."""
    refused: bool = scope.get("state", {}).get("refused", False)
    return refused


def permission_of(request: Request) -> Callable[[], Awaitable[bool]]:
    """Return a function that returns whether a long request is still permitted.

    It is no longer permitted after the sign-out of its session, the end of its key, or a change of
    its user.
    """
    permission: Callable[[], Awaitable[bool]] = request.scope["state"]["permission"]
    return permission


# A coroutine: FastAPI would run a plain function on a thread of the shared pool.
async def _principal(request: Request) -> Principal:
    return principal_of(request)


PrincipalDep = Annotated[Principal, Depends(_principal)]
