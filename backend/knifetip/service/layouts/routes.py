"""Routes for layouts: store, list, get, replace and delete sheets with placed drawings.

A layout is ordered like a drawing: an order names its id as `drawing`.
"""

from __future__ import annotations

from functools import partial
from typing import Annotated

from fastapi import Query, Request, Response

from knifetip.model.layout import Layout
from knifetip.service.accounts.ownership import OwnDrawing
from knifetip.service.components import ServiceDep
from knifetip.service.database.request_key import RequestKey, fingerprint
from knifetip.service.drawings.models import DrawingsQuery
from knifetip.service.http.pages import set_next_page
from knifetip.service.http.parameters import DrawingId, IdempotencyKey
from knifetip.service.http.revisions import IfMatch, check_match, etag
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.layouts.models import LayoutIn, LayoutOut, LayoutPut, LayoutSummary
from knifetip.service.layouts.requests import (
    layout_out,
    replace_layout,
    store_layout,
    stored_layout,
    summary_out,
)
from knifetip.service.limits.work_queue import queued
from knifetip.service.order_details.models import details_columns, details_filter

router = ScopedRouter(prefix="/layouts", tags=["layouts"])


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def add_layout(
    service: ServiceDep, response: Response, layout: LayoutIn, key: IdempotencyKey = None
) -> LayoutOut:
    """Store a layout: a sheet with drawings, each at its place, turned, mirrored and repeated.

    The server composes the drawing of the whole sheet, and reports copies that overlap or extend
    over the edge of the sheet.  To make the sheet, order the layout like a drawing, with its id.
    The layout keeps the present revisions of its drawings.
    """
    request = RequestKey(key, fingerprint(layout.model_dump_json())) if key else None
    sheet = Layout(sheet=layout.sheet, placed=layout.placed)
    row = store_layout(service, layout.name, sheet, details_columns(layout), request)
    response.headers["Location"] = f"/api/layouts/{row.id}"
    response.headers["ETag"] = etag(row.version)
    return layout_out(row)


@router.get("")
@requires(AccessScope.VIEWER)
def list_layouts(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[DrawingsQuery, Query()],
) -> list[LayoutSummary]:
    """List the layouts that meet all conditions, newest first.

    The header ``Link`` contains the URL of the next page.
    """
    conditions = details_filter(wanted, request)
    rows = service.store.drawings.recent(wanted.cursor, wanted.limit, conditions, layouts=True)
    last = rows[-1].serial if len(rows) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return [summary_out(row) for row in rows]


@router.get("/{id}")
@requires(AccessScope.VIEWER)
def get_layout(service: ServiceDep, response: Response, id: DrawingId) -> LayoutOut:
    """Get a layout with the places of all copies, and what is wrong with them."""
    row = stored_layout(service, id)
    response.headers["ETag"] = etag(row.version)
    return layout_out(row)


@router.put("/{id}", dependencies=[OwnDrawing])
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def change_layout(
    service: ServiceDep,
    response: Response,
    id: DrawingId,
    layout: LayoutPut,
    match: IfMatch = None,
) -> LayoutOut:
    """Replace a layout by a new revision; jobs that were ordered keep the earlier one's edges."""
    row = stored_layout(service, id)
    check_match(match, row)
    sheet = Layout(sheet=layout.sheet, placed=layout.placed)
    changed = replace_layout(service, row, layout.name, sheet)
    response.headers["ETag"] = etag(changed.version)
    return layout_out(changed)


@router.delete("/{id}", status_code=204, dependencies=[OwnDrawing])
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def delete_layout(service: ServiceDep, id: DrawingId, match: IfMatch = None) -> None:
    """Delete a layout; the status is 409 if a job uses it."""
    stored_layout(service, id)
    service.store.drawings.delete(id, partial(check_match, match))
