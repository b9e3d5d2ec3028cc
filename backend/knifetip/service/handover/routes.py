"""Routes for handover: job tickets as PDF, and exports of drawings and tool paths."""

from __future__ import annotations

from typing import Annotated, Any, Final, get_args

from fastapi import Depends, Header, Query, Request, Response
from pydantic.json_schema import SkipJsonSchema

from knifetip.fields import LISTED
from knifetip.handover.export import LEAST_WIDTH, MOST_WIDTH, ExportFormat, media_type
from knifetip.messages.languages import accepted_languages, choose_language
from knifetip.service.components import ServiceDep
from knifetip.service.handover import tasks
from knifetip.service.handover.ticket_facts import ticket_data
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.downloads import bytes_response, file_name
from knifetip.service.http.parameters import DrawingId, JobId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import queued

router = ScopedRouter(tags=["handover"])

_BYTES: Final[dict[str, Any]] = {"schema": {"type": "string", "format": "binary"}}
_PDF: Final[dict[str, Any]] = {"content": {"application/pdf": _BYTES}}
_FILES: Final[dict[str, Any]] = {
    "content": {media_type(form): _BYTES for form in get_args(ExportFormat)}
}
Format = Annotated[
    ExportFormat,
    LISTED,
    Query(
        description="Format of the file. svg, dxf and pdf are in true size (mm), with a layer or a "
        "group for each line type or kind of move; png is a picture"
    ),
]
Width = Annotated[
    int,
    Query(
        ge=LEAST_WIDTH,
        le=MOST_WIDTH,
        description="Longer side of the picture for the format png (pixels)",
    ),
]


async def _language(
    language: Annotated[
        str | SkipJsonSchema[None],
        Query(
            max_length=35,
            description="Language of the ticket, such as en or de; that of the header "
            "`Accept-Language` if it is missing",
        ),
    ] = None,
    accept_language: Annotated[str | SkipJsonSchema[None], Header(include_in_schema=False)] = None,
) -> str:
    """Return the tag of the language of an answer."""
    wanted = [language] if language else accepted_languages(accept_language or "")
    return choose_language(wanted)


async def _public_address(request: Request, service: ServiceDep) -> str:
    """Return the URL of the page, as browsers reach it."""
    own = f"{request.url.scheme}://{request.headers.get('host', '')}"
    return service.settings.public_url.rstrip("/") or own


@router.get(
    "/drawings/{id}/export", response_class=Response, responses={200: _FILES, **NOT_MODIFIED}
)
@requires(AccessScope.VIEWER)
@queued
def export_drawing(
    service: ServiceDep, id: DrawingId, format: Format, width: Width = 1600
) -> Response:
    """Export a drawing or the sheet of a layout, with a layer for each line type.

    Ignored edges are left out. A DXF file has the layers CUT, CREASE, V-GROOVE, PERFORATION,
    HALF-CUT, COMBI and UNCLASSIFIED, and is read back with the same lines, arcs and line types. At
    most 200,000 lines and arcs are written as DXF or PDF, and 1,000,000 as SVG or PNG.
    """
    row = service.store.drawings.get_with(id, "edges")
    content = service.run(tasks.export_drawing, row.edges, format, width)
    stem = row.name if row.layout is not None else row.name.rpartition(".")[0] or row.name
    tag = f"{row.version}-{format}-{width}"
    return bytes_response(content, tag, media_type(format), f"{stem}.{format}")


@router.get(
    "/jobs/{id}/toolpath/export",
    response_class=Response,
    responses={200: _FILES, **NOT_MODIFIED},
)
@requires(AccessScope.VIEWER)
@queued
def export_toolpath(
    service: ServiceDep, id: JobId, format: Format, width: Width = 1600
) -> Response:
    """Export the compensated path of a job, in the coordinates of the table.

    The layers are LINE (the drawing at its place), TIP (path of the tool's tip in the board), HEAD
    (path of the head's axis meanwhile) and LIFT (moves in the air). The sizes are limited as those
    of drawings.
    """
    row = service.store.jobs.get(id)
    toolpath = service.store.jobs.column(id, "toolpath")
    drawing = service.store.drawings.get_with(row.drawing, "edges")
    machine = service.store.library.machine(row.machine, row.machine_version)
    content = service.run(tasks.export_path, toolpath, drawing.edges, machine, format, width)
    stem = row.drawing_name.rpartition(".")[0] or row.drawing_name
    tag = f"{row.program_sha256}-{drawing.version}-{format}-{width}"
    return bytes_response(content, tag, media_type(format), f"{stem}-path.{format}")


@router.get("/jobs/{id}/ticket.pdf", response_class=Response, responses={200: _PDF})
@requires(AccessScope.VIEWER)
@queued
def get_ticket(
    service: ServiceDep,
    id: JobId,
    language: Annotated[str, Depends(_language)],
    address: Annotated[str, Depends(_public_address)],
) -> Response:
    """Get the job ticket as PDF, on pages of A4, to be printed for the machine.

    It has a picture of the drawing, the details of the order, board, sheet and place on the table,
    copies, machine, tools, times, lengths, the verdict with accepted exceptions, notes for the
    operator, and a QR code of the station page.
    """
    facts, edges, job = ticket_data(service, id, address)
    fonts = service.settings.fonts
    content = service.run(tasks.write_ticket, facts, edges, job, language, fonts)
    name = file_name(f"ticket-{facts.order or facts.job}.pdf")
    headers = {
        "Cache-Control": "no-cache",
        "Content-Disposition": f'inline; filename="{name}"',
        "Content-Language": language,
        "Vary": "Accept-Language",
    }
    return Response(content, media_type="application/pdf", headers=headers)
