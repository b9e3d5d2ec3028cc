"""Routes for drawings: upload, list, read, and change unit, profile and line types."""

from __future__ import annotations

import hashlib
import json
import unicodedata
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal

import numpy as np
from fastapi import APIRouter, Form, Query, Request, Response, UploadFile
from fastapi.responses import StreamingResponse

from knifetip.api.queue import queued
from knifetip.api.revisions import IfMatch, IfNoneMatch, check_match, etag, is_known
from knifetip.api.schemas.drawings import (
    CleaningOut,
    DrawingOut,
    DrawingPatch,
    DrawingSummary,
    EdgesOut,
    EdgesPatch,
    ImportReportOut,
    OutcomeWord,
    Override,
    Unit,
)
from knifetip.api.service import (
    BINARY,
    Cursor,
    Here,
    Key,
    Limit,
    Service,
    bytes_response,
    customer_rules,
    fingerprint,
    require_customer_profile,
    set_next_page,
)
from knifetip.errors import (
    DrawingTooLarge,
    KnifetipError,
    NotADrawing,
    RequestError,
    StaleRevision,
    WrongState,
)
from knifetip.formats import format_of
from knifetip.geometry.columns import U8
from knifetip.jobs import tasks
from knifetip.jobs.columns import unpacked
from knifetip.jobs.drawing_store import NewDrawing
from knifetip.jobs.interpretations import drawing_columns, interpretation_of
from knifetip.jobs.process_pool import TaskFailed
from knifetip.jobs.tables import Drawing
from knifetip.library import custom_profiles
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation

router = APIRouter(prefix="/drawings", tags=["drawings"])

_NOT_MODIFIED: dict[int | str, dict[str, Any]] = {304: {"description": "Not modified"}}
_TRIES = 3  # attempts to change a drawing that other requests change at the same time
_PIECE = 1000  # edges encoded as JSON at a time
_LISTED = 2000  # most rows of the import report in the JSON of a drawing


@router.post("", status_code=201)
@queued
def upload_drawing(
    here: Here,
    response: Response,
    file: UploadFile,
    unit: Annotated[Unit | None, Form()] = None,
    profile: Annotated[str, Form(max_length=200)] = "default",
    key: Key = None,
) -> DrawingOut:
    """Upload a drawing (DXF, CF2, SVG or PDF, detected by content); read and classify it."""
    customer_rules(here, profile)
    content = file.file.read(here.settings.upload + 1)
    name = drawing_name(file.filename or "")
    return add_drawing(here, response, name, content, unit or "", profile, key)


def add_drawing(
    here: Service,
    response: Response | None,
    name: str,
    content: bytes,
    unit: str,
    profile: str,
    key: str | None = None,
) -> DrawingOut:
    """Read, classify and store a drawing."""
    if len(content) > here.settings.upload:
        raise DrawingTooLarge(
            "drawing.upload-too-large", name=name, limit=here.settings.upload >> 20
        )
    rules = customer_rules(here, profile)
    sha256 = hashlib.sha256(content).hexdigest()
    request = fingerprint(name, sha256, unit, profile)
    row = here.store.drawings.find(key, request) if key else None
    if row is None:
        interpretation = Interpretation(unit, profile, rules)
        reading = read_drawing(here, name, content, interpretation)
        new = NewDrawing(
            name=name,
            content=content,
            sha256=sha256,
            interpretation=replace(interpretation, overrides=reading.overrides),
            summary=reading.summary,
            edges=reading.edges,
            import_report=reading.import_report,
        )
        row = here.store.drawings.add(new, key=key, fingerprint=request)
    drawing = drawing_out(here, row)
    if response is not None:
        response.headers["Location"] = f"/api/drawings/{row.id}"
        response.headers["ETag"] = _etag_of(drawing)
    return drawing


@router.get("")
def list_drawings(
    here: Here, response: Response, cursor: Cursor = None, limit: Limit = 100
) -> list[DrawingSummary]:
    """List drawings, newest first; the Link header contains the next page."""
    rows = here.store.drawings.recent(cursor, limit)
    last = rows[-1].serial if len(rows) == limit else None
    set_next_page(response, "/api/drawings?", last, limit)
    return [summary_out(row) for row in rows]


@router.get("/{id}", response_model=DrawingOut, responses=_NOT_MODIFIED)
def get_drawing(
    here: Here, response: Response, id: str, known: IfNoneMatch = None
) -> DrawingOut | Response:
    """Get a drawing."""
    row = here.store.drawings.get_with(id, "import_report")
    headers = {"ETag": etag(row.version, _profile_state(here, row)), "Cache-Control": "no-cache"}
    if is_known(headers["ETag"], known):
        return Response(status_code=304, headers=headers)
    response.headers.update(headers)
    return drawing_out(here, row)


@router.patch("/{id}")
@queued
def change_drawing(
    here: Here, response: Response, id: str, patch: DrawingPatch, match: IfMatch = None
) -> DrawingOut:
    """Set the unit of a drawing, or classify it with another profile or an earlier version."""

    def decide(row: Drawing) -> _Change:
        unit = row.unit_given
        if patch.unit is not None:
            unit = "" if patch.unit == "file" else patch.unit
        profile, rules = row.profile, row.rules
        if patch.rules:
            profile, rules = patch.profile or row.profile, patch.rules
            custom_profiles.check_name(profile)
            require_customer_profile(here, profile)
            custom_profiles.parse_text(profile, rules)
        elif patch.profile is not None:
            profile, rules = patch.profile, customer_rules(here, patch.profile)
        event = Message("drawing.reinterpreted", unit=unit, profile=profile)
        return _Change(Interpretation(unit, profile, rules, row.overrides), event)

    return _apply_change(here, response, id, match, decide)


@router.delete("/{id}", status_code=204)
def delete_drawing(here: Here, id: str) -> None:
    """Delete a drawing without jobs."""
    here.store.drawings.delete(id)


@router.get("/{id}/edges", response_model=EdgesOut, responses={200: BINARY, **_NOT_MODIFIED})
def get_edges(
    here: Here,
    request: Request,
    id: str,
    format: Annotated[Literal["json", "columns"], Query()] = "json",
) -> Response:
    """List the edges, as JSON or as binary columns (``format=columns``)."""
    row = here.store.drawings.get_with(id, "edges")
    if format == "columns":
        return bytes_response(request, row.edges, str(row.version), "application/octet-stream")
    headers = {"ETag": etag(row.version), "Cache-Control": "no-cache"}
    if is_known(headers["ETag"], request.headers.get("if-none-match")):
        return Response(status_code=304, headers=headers)
    pieces = edges_json(row.edges)
    return StreamingResponse(pieces, media_type="application/json", headers=headers)


@router.patch("/{id}/edges")
@queued
def override_edges(
    here: Here, response: Response, id: str, patch: EdgesPatch, match: IfMatch = None
) -> DrawingOut:
    """Set line types of edges; later overrides replace earlier ones."""

    def decide(row: Drawing) -> _Change:
        overrides = merge_overrides(row.edges, row.overrides, patch.overrides)
        event = Message("drawing.types-set", count=len(patch.overrides))
        return _Change(interpretation_of(row, overrides), event)

    return _apply_change(here, response, id, match, decide)


@router.get("/{id}/import-report")
def get_import_report(here: Here, id: str, outcome: OutcomeWord | None = None) -> ImportReportOut:
    """Get the import report: all entities of the file, or only those with one outcome."""
    row = here.store.drawings.get_with(id, "import_report")
    rows = [one for one in _report_rows(row) if outcome in (None, one["outcome"])]
    return ImportReportOut.model_validate({**row.summary["import_report"], "rows": rows})


@router.get("/{id}/cleaning")
@queued
def get_cleaning(here: Here, id: str) -> CleaningOut:
    """Get the cleaning report: edges merged, shortened, joined or dropped before planning."""
    edges = here.store.drawings.column(id, "edges")
    return CleaningOut.model_validate(here.run(tasks.cleaned, edges))


@router.get("/{id}/file", response_class=Response, responses={200: BINARY})
def get_file(here: Here, request: Request, id: str) -> Response:
    """Download the uploaded file."""
    row = here.store.drawings.get(id)
    content = here.store.drawings.column(id, "content")
    return bytes_response(request, content, row.sha256, format_of(content).media_type, row.name)


def read_drawing(
    here: Service,
    name: str,
    content: bytes,
    interpretation: Interpretation,
    handles: Sequence[str] | None = None,
) -> tasks.Reading:
    """Read a drawing in a worker process; parameters as for ``tasks.read``.

    Raises
    ------
    ReadError
        The drawing cannot be read; the message starts with its name.
    """
    try:
        return here.run(tasks.read, content, interpretation, handles)
    except TaskFailed as reason:
        raise NotADrawing("reading.crashed", name=name, reason=reason) from reason
    except KnifetipError as reason:
        if reason.message.arguments.get("name") != name:
            reason.message = Message("error.in-file", name=name, error=reason.message)
        raise


@dataclass(frozen=True, slots=True)
class _Change:
    """New interpretation of a drawing and the reason for the event log."""

    interpretation: Interpretation
    event: Message


def _apply_change(
    here: Service,
    response: Response,
    id: str,
    match: str | None,
    decide: Callable[[Drawing], _Change],
) -> DrawingOut:
    """Change a drawing; ``decide`` returns the change for its newest revision.

    Raises
    ------
    StaleRevision
        The request names another revision.
    WrongState
        Other requests changed the drawing at every attempt.
    """
    for _ in range(_TRIES):
        row = here.store.drawings.get_with(id, "content", "overrides", "edges")
        check_match(match, row)
        change = decide(row)
        handles = unpacked(row.edges)[1]["handles"]
        reading = read_drawing(here, row.name, row.content, change.interpretation, handles)
        final = replace(change.interpretation, overrides=reading.overrides)
        try:
            changed = here.store.drawings.change(
                row.id,
                row.version,
                change.event,
                **drawing_columns(final),
                summary=reading.summary,
                edges=reading.edges,
                import_report=reading.import_report,
            )
        except StaleRevision:
            # A request without a revision applies to the newest one: try again.
            if match is not None and match.strip() != "*":
                raise
            continue
        drawing = drawing_out(here, changed)
        response.headers["ETag"] = _etag_of(drawing)
        return drawing
    raise WrongState("drawing.changing", drawing=id)


def _etag_of(drawing: DrawingOut) -> str:
    return etag(drawing.revision, drawing.profile_state)


def merge_overrides(block: bytes, before: bytes, overrides: Sequence[Override]) -> bytes:
    """Return a column of overrides with further overrides applied.

    Parameters
    ----------
    block
        The drawing's edges, see ``columns``.
    before
        (n,) uint8, ``NO_OVERRIDE`` or a LineType.

    Raises
    ------
    RequestError
        An override selects no edge, or is ambiguous.
    """
    columns, meta = unpacked(block)
    after = np.frombuffer(before, np.uint8).copy()
    rows_of: dict[str, list[int]] = {}
    if any(override.handles is not None for override in overrides):
        for row, handle in enumerate(meta["handles"]):
            rows_of.setdefault(handle, []).append(row)
    for override in overrides:
        value = NO_OVERRIDE if override.type is None else LineType.of(override.type)
        after[_select_edges(override, columns, meta["layers"], rows_of, len(after))] = value
    return after.tobytes()


def _select_edges(
    override: Override,
    columns: dict[str, Any],
    layers: list[str],
    rows_of: dict[str, list[int]],
    count: int,
) -> U8 | list[int]:
    by_layer = override.layer is not None or override.colour is not None
    if (override.edges is not None) + (override.handles is not None) + by_layer != 1:
        raise RequestError("override.ambiguous")
    if override.edges is not None:
        if wrong := [str(row) for row in override.edges if not 0 <= row < count]:
            raise RequestError(
                "override.no-such-edge", count=count, edge=wrong[0][:20], source=wrong[:20]
            )
        return override.edges
    if override.handles is not None:
        if wrong := [handle for handle in override.handles if handle not in rows_of]:
            raise RequestError("override.no-such-handle", handle=wrong[0][:40], source=wrong[:20])
        return [row for handle in override.handles for row in rows_of[handle]]
    chosen = np.ones(count, bool)
    place = []
    if override.layer is not None:
        same = [index for index, name in enumerate(layers) if name == override.layer]
        chosen &= np.isin(columns["layer"], same)
        place.append(Message("override.on-layer", layer=override.layer[:80]))
    if override.colour is not None:
        colour = override.colour if 0 <= override.colour < 1000 else -1
        chosen &= columns["colour"] == colour
        place.append(Message("override.of-colour", colour=str(override.colour)[:20]))
    if not chosen.any():
        raise RequestError("override.no-edges-there", place=place)
    return np.flatnonzero(chosen).tolist()


def drawing_name(given: str) -> str:
    """Return a file name without folders and control characters, at most 120 long."""
    last = given.replace("\\", "/").rsplit("/", 1)[-1]
    shown = "".join(sign for sign in last if unicodedata.category(sign)[0] != "C").strip()
    if len(shown) > 120:
        stem, dot, suffix = shown.rpartition(".")
        shown = stem[:110] + dot + suffix[:9] if dot and stem else shown[:120]
    return shown or "drawing.dxf"


def edges_json(block: bytes) -> Iterator[bytes]:
    """Yield the JSON of ``EdgesOut`` in pieces, so that other threads can run in between."""
    columns, meta = unpacked(block)
    count = len(columns["ends"])
    # Drawings stored by older versions have no outcomes.
    missing = np.zeros(count, np.int32)
    columns = {"outcome": missing, "reason": missing, **columns}
    meta = {"outcomes": ["kept"], "reasons": [""], "alternatives": [], **meta}
    yield b'{"edges":['
    for first in range(0, count, _PIECE):
        rows = _edge_rows(columns, meta, first, min(first + _PIECE, count))
        text = json.dumps(rows, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
        yield (("," if first else "") + text[1:-1]).encode()
    yield b"]}"


def _edge_rows(
    columns: dict[str, Any], meta: dict[str, Any], first: int, last: int
) -> list[dict[str, Any]]:
    """Return edges ``first`` … ``last - 1`` as JSON data (``EdgeOut``)."""
    listed = {name: column[first:last].tolist() for name, column in columns.items()}
    alternatives = meta["alternatives"]
    return [
        {
            "row": first + at,
            "handle": meta["handles"][first + at],
            "layer": meta["layers"][listed["layer"][at]],
            "colour": listed["colour"][at],
            "linetype": meta["linetypes"][listed["linetype"][at]],
            "type": meta["types"][listed["line_type"][at]],
            "rule": meta["rules"][listed["rule"][at]],
            "confidence": listed["confidence"][at],
            "alternatives": alternatives[listed["rule"][at]] if alternatives else [],
            "outcome": meta["outcomes"][listed["outcome"][at]],
            "reason": meta["reasons"][listed["reason"][at]],
            "length": listed["length"][at],
            "start": start,
            "end": end,
            "bulge": listed["bulge"][at],
        }
        for at, (start, end) in enumerate(listed["ends"])
    ]


def _report_rows(row: Drawing, most: int | None = None) -> list[dict[str, Any]]:
    """Return the rows of a drawing's import report, or the first ``most`` rows."""
    text = zlib.decompress(row.import_report).decode()
    rows: list[dict[str, Any]] = json.loads(text) if most is None else _first_elements(text, most)
    return rows


def _first_elements(text: str, most: int) -> list[dict[str, Any]]:
    """Return the first elements of a JSON list without parsing the rest."""
    scan = json.JSONDecoder().raw_decode
    rows: list[dict[str, Any]] = []
    at = 1
    while len(rows) < most:
        while at < len(text) and text[at] in " ,]":
            at += 1
        if at >= len(text):
            break
        row, at = scan(text, at)
        rows.append(row)
    return rows


def drawing_out(here: Service, row: Drawing) -> DrawingOut:
    """Return the API model of a drawing whose ``import_report`` column is loaded."""
    import_report = row.summary["import_report"]
    return DrawingOut.model_validate(
        {
            **row.summary,
            "unit": row.summary["unit"] or None,
            "id": row.id,
            "revision": row.version,
            "name": row.name,
            "created": row.created,
            "sha256": row.sha256,
            "profile": row.profile,
            "profile_state": _profile_state(here, row),
            "rules": row.rules,
            "unit_given": row.unit_given or None,
            "import_report": {**import_report, "rows": _report_rows(row, _LISTED)},
        }
    )


def _profile_state(here: Service, row: Drawing) -> str:
    """Return whether the profile is current, changed or deleted since the classification."""
    stored = here.store.profiles.get(row.profile)
    if stored is None:
        return "deleted" if row.rules else "current"
    return "current" if stored.text == row.rules else "changed"


def summary_out(row: Drawing) -> DrawingSummary:
    """Return the summary of a drawing for lists."""
    return DrawingSummary(
        id=row.id,
        revision=row.version,
        name=row.name,
        created=row.created,
        unit=row.summary["unit"] or None,
        width=row.summary["width"],
        height=row.summary["height"],
        segments=row.summary["segments"],
        questions=len(row.summary["questions"]),
    )
