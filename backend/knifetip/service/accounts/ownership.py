"""Who may change a drawing or a job: its owner, and operators (ADR 103).

Designers change their own drawings and those that are shared; programs with the scope ``order``
release, change and cancel the jobs that they have ordered.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Final

from fastapi import Depends

from knifetip.contract.job import LEASED, State
from knifetip.errors import AccessDenied
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.acting import acting_owner
from knifetip.service.database.tables import Drawing
from knifetip.service.http.parameters import DrawingId
from knifetip.service.http.principal import Principal, PrincipalDep, demand
from knifetip.service.http.scopes import AccessScope

#: States in which a program may change its own job.
_OFF_TABLE: Final = tuple(state for state in State if state not in LEASED)
_AT_MACHINE: Final = (State.QUEUED, *LEASED, State.CANCELLED)
_BEFORE_QUEUE: Final = (
    *(State.RECEIVED, State.COMPILING, State.READY, State.REFUSED),
    State.CANCELLED,
)


def _own_drawing(service: ServiceDep, principal: PrincipalDep, id: DrawingId) -> None:
    check_drawing(principal, service.store.drawings.get(id))


#: Dependency of a route that changes the drawing in its path.
OwnDrawing: Final = Depends(_own_drawing)


def check_drawing(principal: Principal, row: Drawing) -> None:
    """Raise ``AccessDenied`` unless a principal may change a drawing."""
    is_open = row.shared or row.owner in ("", acting_owner())
    if not is_open and AccessScope.OPERATOR not in principal.scopes:
        raise AccessDenied("drawing.of-another", drawing=row.id)


def check_own_job(
    service: Service, principal: Principal, id: str, states: Collection[State] = _OFF_TABLE
) -> None:
    """Raise ``AccessDenied`` unless a principal may command a job.

    Operators may command all jobs, programs with the scope ``order`` those that they have ordered.

    Parameters
    ----------
    service, principal
        The server, and the sender of the request.
    id
        Id of the job.
    states
        States of the job in which a program may do so.

    Raises
    ------
    NotFound
        There is no such job, or the principal may not see it.
    """
    if AccessScope.OPERATOR in principal.scopes:
        return
    row = service.store.jobs.get(id)
    own = row.ordered_by != "" and row.ordered_by == acting_owner()
    if AccessScope.ORDER not in principal.scopes or not own or row.state not in states:
        demand(principal, AccessScope.OPERATOR)


def check_withdrawal(service: Service, principal: Principal, id: str) -> None:
    """Raise ``AccessDenied`` unless a principal may withdraw a job.

    Operators may do so with all jobs, the person at a machine with those that are on it or wait for
    it, designers with those that they have ordered and that are not queued yet, programs with those
    that they have ordered until a machine works on them.
    """
    at_machine = AccessScope.STATION in principal.scopes
    if at_machine and service.store.jobs.get(id).state in _AT_MACHINE:
        return
    if AccessScope.ORDER in principal.scopes:
        check_own_job(service, principal, id)
        return
    if AccessScope.OPERATOR in principal.scopes:
        return
    row = service.store.jobs.get(id)
    if row.state not in _BEFORE_QUEUE or row.ordered_by != acting_owner():
        demand(principal, AccessScope.OPERATOR)
