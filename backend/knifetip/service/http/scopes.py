"""scopes: the permissions of users and API keys.

Each role contains the scopes of the roles below it: viewer, designer, operator, admin.  The other
scopes are those of programs, and API keys have them only if they are named:

- ``read``, ``order`` and ``station`` contain viewer;
- ``station`` starts and moves machines; people have it with the role operator;
- ``gateway`` permits the requests of a program that controls a machine.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from typing import Final


class AccessScope(StrEnum):
    """One permission of a user or an API key."""

    VIEWER = "viewer"  #: read drawings, jobs, programs and machines
    DESIGNER = "designer"  #: upload and change drawings, order jobs, change profiles
    OPERATOR = "operator"  #: release, order and control jobs, and switch stations
    ADMIN = "admin"  #: change the library, manage users and keys, read the audit log
    GATEWAY = "gateway"  #: claim jobs for a machine and report on them
    READ = "read"  #: read what a viewer reads
    ORDER = "order"  #: upload drawings, order jobs, and release, change and cancel those
    WEBHOOKS = "webhooks"  #: add and manage webhooks of its own
    STATION = "station"  #: start, confirm, continue and move a machine, as the person at it does


#: Scopes that users have as roles, least first.
ROLES: Final = (
    AccessScope.VIEWER,
    AccessScope.DESIGNER,
    AccessScope.OPERATOR,
    AccessScope.ADMIN,
)
ALL_SCOPES: Final = frozenset(AccessScope)
#: What a scope that is no role contains.
_CONTAINED: Final = dict.fromkeys(
    (AccessScope.READ, AccessScope.ORDER, AccessScope.STATION), (AccessScope.VIEWER,)
)
#: Scopes of keys that can be limited to a customer, and those that can be limited to machines.
FOR_CUSTOMER: Final = frozenset(
    {AccessScope.VIEWER, AccessScope.READ, AccessScope.ORDER, AccessScope.WEBHOOKS}
)
FOR_MACHINES: Final = FOR_CUSTOMER | {AccessScope.STATION, AccessScope.GATEWAY}


def scopes_of(granted: Iterable[AccessScope]) -> frozenset[AccessScope]:
    """Return the scopes of an API key: those that are granted and those that they contain."""
    found: set[AccessScope] = set()
    for scope in granted:
        lesser = ROLES[: ROLES.index(scope)] if scope in ROLES else _CONTAINED.get(scope, ())
        found |= {scope, *lesser}
    return frozenset(found)


def scopes_of_role(role: AccessScope) -> frozenset[AccessScope]:
    """Return the scopes of a person with a role; an operator may start and move machines."""
    found = scopes_of([role])
    return found | {AccessScope.STATION} if AccessScope.OPERATOR in found else found


def least_role(scope: AccessScope) -> AccessScope | None:
    """Return the least role whose users have a scope; None if no user has it."""
    return next((role for role in ROLES if scope in scopes_of_role(role)), None)
