"""Routes for drawings: upload, list, get, and change the unit, the profile or line types."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any

from fastapi import Depends, File, Form, Path, Query, Request, Response, UploadFile
from fastapi.concurrency import run_in_threadpool
from pydantic.json_schema import SkipJsonSchema

from knifetip import formats
from knifetip.errors import WrongState
from knifetip.formats import FORMATS, format_of
from knifetip.library import custom_profiles
from knifetip.messages import Message
from knifetip.model.edit import edits_from_json
from knifetip.model.interpretation import Interpretation
from knifetip.presentation.drawn_edges import MANY_EDGES
from knifetip.service.accounts.ownership import OwnDrawing
from knifetip.service.components import ServiceDep
from knifetip.service.database.tables import Drawing
from knifetip.service.documents.responses import AnswerDep
from knifetip.service.drawings.customer_profiles import customer_rules, require_customer_profile
from knifetip.service.drawings.documents import (
    blanks_document,
    cleaning_document,
    drawing_document,
    drawn_edges_document,
    edges_document,
    import_report_document,
    pages_document,
    picture_document,
)
from knifetip.service.drawings.interpretations import interpretation_of
from knifetip.service.drawings.models import (
    DrawingOut,
    DrawingPatch,
    DrawingsQuery,
    DrawingSummary,
    EdgesOut,
    EdgesPatch,
    PageOut,
    Unit,
)
from knifetip.service.drawings.overrides import merge_overrides
from knifetip.service.drawings.report_models import (
    BlanksOut,
    CleaningOut,
    ImportReportOut,
    OutcomeWord,
)
from knifetip.service.drawings.requests import (
    Change,
    Upload,
    add_drawing,
    apply_change,
    change_details,
    drawing_name,
    learned_for,
    learned_unit,
    summary_out,
)
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.downloads import BINARY, bytes_response
from knifetip.service.http.pages import set_next_page
from knifetip.service.http.parameters import DrawingId, EdgesFormat, IdempotencyKey
from knifetip.service.http.revisions import IfMatch, check_match
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import MomentIn
from knifetip.service.limits.work_queue import queued
from knifetip.service.order_details.models import (
    Customer,
    ExternalId,
    Notes,
    OrderDetailsPatch,
    changed_columns,
    details_filter,
    metadata_of,
)

router = ScopedRouter(prefix="/drawings", tags=["drawings"])

_SVG: dict[str, Any] = {"content": {"image/svg+xml": {"schema": {"type": "string"}}}}
_BYTES: dict[str, Any] = {"schema": {"type": "string", "format": "binary"}}
_FILE: dict[str, Any] = {
    "content": dict.fromkeys(sorted({one.media_type for one in FORMATS}), _BYTES)
}


@dataclass(frozen=True, slots=True)
class UploadForm:
    """The fields of an upload beside its file."""

    unit: Annotated[
        Unit | SkipJsonSchema[None],
        Form(description="Unit of the drawing; the unit of the file if it is missing"),
    ] = None
    profile: Annotated[
        str, Form(max_length=200, description="Name of the classification profile")
    ] = "default"
    external_id: Annotated[ExternalId, Form()] = ""
    customer: Annotated[Customer, Form()] = ""
    due: Annotated[
        MomentIn | SkipJsonSchema[None],
        Form(description="Time at which the order is due, with offset"),
    ] = None
    notes: Annotated[Notes, Form()] = ""
    metadata: Annotated[
        str,
        Form(
            max_length=20_000,
            description="JSON object with values of other systems by key; empty for none",
        ),
    ] = ""

    def details(self) -> dict[str, Any]:
        """Return the details of the order, as columns of the drawing."""
        return {
            "external_id": self.external_id,
            "customer": self.customer,
            "due": self.due,
            "notes": self.notes,
            "extra": metadata_of(self.metadata),
        }


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def upload_drawing(
    service: ServiceDep,
    response: Response,
    file: Annotated[UploadFile, File(description="Drawing in a format that `GET /formats` lists")],
    form: Annotated[UploadForm, Depends()],
    key: IdempotencyKey = None,
) -> DrawingOut:
    """Upload a drawing; the server reads it and classifies its edges.

    The format is detected from the content of the file: DXF, CF2, SVG, PDF, HPGL or LightBurn, and
    EPS, PostScript or DWG if the program that converts them is installed on the server.
    """
    customer_rules(service, form.profile)
    content = file.file.read(service.settings.upload_bytes + 1)
    name = drawing_name(file.filename or "")
    upload = Upload(name, content, form.unit or "", form.profile, details=form.details())
    return add_drawing(service, response, upload, key)


@router.get("", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def list_drawings(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[DrawingsQuery, Query()],
) -> list[DrawingSummary]:
    """List the drawings that meet all conditions, newest first.

    The header ``Link`` contains the URL of the next page.
    """
    conditions = details_filter(wanted, request)
    rows = service.store.drawings.recent(wanted.cursor, wanted.limit, conditions)
    last = rows[-1].serial if len(rows) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return [summary_out(row) for row in rows]


@router.get("/{id}", response_model=DrawingOut, responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
async def get_drawing(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
) -> Response:
    """Get a drawing with its import report and the questions that the user must still answer.

    The status is 304 if ``If-None-Match`` contains the ETag of the drawing.
    """
    return await answer.send(id, drawing_document(service))


@router.patch("/{id}", dependencies=[OwnDrawing])
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def change_drawing(
    service: ServiceDep,
    response: Response,
    id: DrawingId,
    patch: DrawingPatch,
    match: IfMatch = None,
) -> DrawingOut:
    """Set unit, profile or edits of a drawing, or change the details of its order.

    The drawing gets a new revision.  It is read and classified again, unless the request changes
    details of the order or the share only.  A new customer is no such detail, because answers in
    earlier drawings of the customer also apply to this one.  The owner of the drawing and operators
    may change it, and all designers if it is shared.
    """
    details = changed_columns(patch)
    if patch.shared is not None:
        details["shared"] = patch.shared
    only_details = not patch.model_fields_set - {*OrderDetailsPatch.model_fields, "shared"}
    # The drawings of another customer teach something else.
    if details and only_details and "customer" not in details:
        return change_details(service, response, id, match, details)

    def decide(row: Drawing) -> Change:
        unit = row.unit_given
        if patch.unit is not None:
            unit = "" if patch.unit == "file" else patch.unit
        profile, rules = row.profile, row.rules
        if patch.rules:
            profile, rules = patch.profile or row.profile, patch.rules
            custom_profiles.check_name(profile)
            require_customer_profile(service, profile)
            custom_profiles.parse_text(profile, rules)
        elif patch.profile is not None:
            profile, rules = patch.profile, customer_rules(service, patch.profile)
        customer = details.get("customer", row.customer)
        learned = learned_for(service, customer, row.sha256, row.id)
        columns = dict(details)
        if patch.unit is not None:
            columns["unit_learned"] = []
        elif not unit and row.summary["unit"] is None:
            found = learned_unit(service, customer, row.name, row.sha256, row.id)
            if found is not None:
                unit, columns["unit_learned"] = found.unit, list(found.drawings)
        event = Message("drawing.reinterpreted", unit=unit, profile=profile)
        edits = edits_from_json(row.edits) if patch.edits is None else tuple(patch.edits)
        if edits and unit != row.unit_given:
            raise WrongState("edit.unit-changed")
        if patch.edits is not None:
            event = Message("drawing.edited", count=len(edits))
        if only_details:
            event = Message("drawing.details-changed")
        after = Interpretation(unit, profile, rules, row.overrides, learned=learned, edits=edits)
        return Change(after, event, columns)

    return apply_change(service, response, id, match, decide)


@router.delete("/{id}", status_code=204, dependencies=[OwnDrawing])
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def delete_drawing(service: ServiceDep, id: DrawingId, match: IfMatch = None) -> None:
    """Delete a drawing, and what it taught; the status is 409 if a job uses the drawing."""
    service.store.drawings.delete(id, partial(check_match, match))
    service.store.customer_answers.forget(id)


@router.get("/{id}/edges", response_model=EdgesOut, responses={200: BINARY, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
async def get_edges(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
    format: EdgesFormat = "json",
) -> Response:
    """List the edges of a drawing, as JSON or as binary arrays (``format=columns``).

    With ``format=drawn`` the response has only what a picture needs if there are many edges.
    """
    if format == "drawn":
        summary = (await run_in_threadpool(service.store.drawings.get_with, id)).summary
        if int(summary["segments"]) >= MANY_EDGES:
            return await answer.send(id, drawn_edges_document(service))
    if format != "json":
        row = await run_in_threadpool(service.store.drawings.get_with, id, "edges")
        return bytes_response(row.edges, str(row.version), "application/octet-stream")
    return await answer.send(id, edges_document(service))


@router.get("/{id}/picture", response_class=Response, responses={200: _SVG, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
async def get_picture(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
) -> Response:
    """Get a small picture of a drawing as SVG, with its edges in the colours of line types."""
    return await answer.send(id, picture_document(service))


@router.patch("/{id}/edges", dependencies=[OwnDrawing])
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def override_edges(
    service: ServiceDep, response: Response, id: DrawingId, patch: EdgesPatch, match: IfMatch = None
) -> DrawingOut:
    """Set line types of edges, which replace the line types found by classification.

    A line type that an earlier request set for one of the edges is also replaced.
    """

    def decide(row: Drawing) -> Change:
        overrides = merge_overrides(row.edges, row.overrides, patch.overrides)
        event = Message("drawing.types-set", count=len(patch.overrides))
        return Change(interpretation_of(row, overrides), event)

    return apply_change(service, response, id, match, decide)


@router.get("/{id}/import-report", response_model=ImportReportOut, responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
async def get_import_report(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
    outcome: Annotated[
        OutcomeWord | None,
        Query(description="List only entities with this outcome; all if it is missing"),
    ] = None,
) -> Response:
    """Get the import report of a drawing: all entities of its file, or those with one outcome."""
    return await answer.send(id, import_report_document(service, outcome))


@router.get("/{id}/cleaning", response_model=CleaningOut, responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
async def get_cleaning(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
) -> Response:
    """Get the cleaning report of a drawing: the edges that cleaning changes before planning.

    Cleaning merges, shortens, joins and drops edges.
    """
    return await answer.send(id, cleaning_document(service))


@router.get("/{id}/blanks", response_model=BlanksOut, responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
async def get_blanks(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
) -> Response:
    """Get the blanks of a drawing: the areas of board that its closed cuts enclose.

    The areas are those of the material that a blank needs, without its holes. Arcs of the outlines
    are polylines, which deviate by at most 0.02 mm. Edges that are not classified yet as cuts do
    not count.
    """
    return await answer.send(id, blanks_document(service))


@router.get("/{id}/pages", response_model=list[PageOut], responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
async def list_pages(service: ServiceDep, answer: AnswerDep, id: DrawingId) -> Response:
    """List the pages of the file of a drawing, at most 24, each with a picture of its edges.

    The list is empty if files of this format have no pages.
    """
    return await answer.send(id, pages_document(service))


@router.post("/{id}/pages/{page}", status_code=201)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def choose_page(
    service: ServiceDep,
    response: Response,
    id: DrawingId,
    page: Annotated[int, Path(ge=1, le=999_999, description="Number of the page, from 1")],
) -> DrawingOut:
    """Read another page of the file of a drawing, as a new drawing.

    The new drawing has the unit, the profile with its rules, and the details of the order of this
    one.
    """
    row = service.store.drawings.get_with(id, "content")
    if row.layout is not None:
        raise WrongState("layout.read-only", layout=row.name)
    details = ("external_id", "customer", "due", "notes", "extra")
    upload = Upload(
        row.name,
        formats.choose_page(row.content, page),
        row.unit_given,
        row.profile,
        row.rules,
        {name: getattr(row, name) for name in details},
    )
    return add_drawing(service, response, upload)


@router.get("/{id}/file", response_class=Response, responses={200: _FILE, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
def get_file(service: ServiceDep, id: DrawingId) -> Response:
    """Download the uploaded file of a drawing."""
    row = service.store.drawings.get(id)
    content = service.store.drawings.column(id, "content")
    if row.layout is not None:
        return bytes_response(content, row.sha256, "application/zip", f"{row.name}.zip")
    return bytes_response(content, row.sha256, format_of(content).media_type, row.name)
