"""Routes for ended jobs and for statistics of the machines."""

from __future__ import annotations

from typing import Annotated
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from fastapi import Query, Request, Response

from knifetip.errors import RequestError
from knifetip.service.components import ServiceDep
from knifetip.service.history.models import HistoryQuery, StatisticsOut, StatisticsQuery
from knifetip.service.history.store import HistoryFilter
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.pages import set_next_page
from knifetip.service.http.principal import PrincipalDep, demand_all_customers
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import rfc3339
from knifetip.service.order_details.models import details_filter
from knifetip.service.orders.job_answers import jobs_out
from knifetip.service.orders.models import JobOut

router = ScopedRouter(tags=["history"])

_END = 1e11  # later than all times


@router.get("/history", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def list_history(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[HistoryQuery, Query()],
) -> list[JobOut]:
    """List ended jobs, the last ended first; the header ``Link`` contains the URL of the next page.

    Ended jobs are done, refused, interrupted, scrapped, cancelled, or continued by a job for the
    rest of the sheet.
    """
    conditions = HistoryFilter(
        wanted.state,
        wanted.machine,
        wanted.board,
        wanted.drawing,
        wanted.since,
        wanted.until,
        details_filter(wanted, request),
    )
    after = None
    if wanted.cursor is not None:
        end, _, serial = wanted.cursor.partition("-")
        after = float(end), int(serial)
    rows = service.store.history.search(conditions, after, wanted.limit)
    if len(rows) == wanted.limit:
        cursor = f"{rows[-1].ended!r}-{rows[-1].serial}"
        set_next_page(request, response, cursor, wanted.limit)
    return jobs_out(service.store, rows)


@router.get("/statistics")
@requires(AccessScope.VIEWER)
def get_statistics(
    service: ServiceDep, principal: PrincipalDep, wanted: Annotated[StatisticsQuery, Query()]
) -> list[StatisticsOut]:
    """Get statistics of each machine and period: jobs, sheets, lengths, time and interruptions.

    A run counts for the period in which it ended.  Periods without runs are left out.  The status
    is 403 for a key that is limited to a customer, because the sums contain all customers.
    """
    demand_all_customers(principal)
    try:
        zone = ZoneInfo(wanted.zone)
    except (ZoneInfoNotFoundError, ValueError, OSError) as reason:
        raise RequestError("request.unknown-zone", zone=wanted.zone[:60]) from reason
    sums = service.store.statistics.sums(
        wanted.since or 0.0,
        _END if wanted.until is None else wanted.until,
        wanted.step,
        zone,
        wanted.machine,
    )
    return [
        StatisticsOut(
            machine=one.machine,
            start=rfc3339(one.start),
            jobs=one.jobs,
            copies=one.copies,
            runs=one.runs,
            interruptions=one.interruptions,
            interrupted_share=one.interruptions / one.runs,
            seconds=one.seconds,
            sheets=one.sheets,
            lengths={kind: length / 1000.0 for kind, length in one.lengths.items()},
        )
        for one in sums
        if principal.limits.sees_machine(one.machine)
    ]
