"""scopes: the permissions of users and API keys.

Each role contains the scopes of the roles below it: viewer, designer, operator, admin.  The scope
``gateway`` is in no role: it permits the requests of a program that controls a machine.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from typing import Final


class AccessScope(StrEnum):
    """One permission of a user or an API key."""

    VIEWER = "viewer"  #: read drawings, jobs, programs and machines
    DESIGNER = "designer"  #: upload and change drawings, order jobs, change profiles
    OPERATOR = "operator"  #: release, order and control jobs, and operate machines
    ADMIN = "admin"  #: change the library, manage users and keys, read the audit log
    GATEWAY = "gateway"  #: claim jobs for a machine and report on them


#: Scopes that users have as roles, least first.
ROLES: Final = (
    AccessScope.VIEWER,
    AccessScope.DESIGNER,
    AccessScope.OPERATOR,
    AccessScope.ADMIN,
)
ALL_SCOPES: Final = frozenset(AccessScope)


def scopes_of(granted: Iterable[AccessScope]) -> frozenset[AccessScope]:
    """Return the granted scopes together with the scopes that they contain."""
    found: set[AccessScope] = set()
    for scope in granted:
        found |= set(ROLES[: ROLES.index(scope) + 1]) if scope in ROLES else {scope}
    return frozenset(found)
