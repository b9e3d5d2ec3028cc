"""drawings: upload, look at, decide about."""

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
    FateWord,
    LedgerOut,
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
    bytes_answer,
    fingerprint,
    next_page,
    not_shipped,
    rules_named,
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
from knifetip.jobs.interpretations import drawing_columns, interpretation_of
from knifetip.jobs.process_pool import TaskFailed
from knifetip.jobs.tables import Drawing
from knifetip.library import custom_profiles
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation

router = APIRouter(prefix="/drawings", tags=["drawings"])

_NOT_MODIFIED: dict[int | str, dict[str, Any]] = {304: {"description": "As it was"}}
_TRIES = 3  # of a change to a drawing that others change at the same time
_PIECE = 1000  # edges that are put into JSON at once
_LISTED = 2000  # ledger rows in a drawing's own answer


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
    """Read and classify a drawing: DXF (text or binary), CF2, SVG or PDF, told by its content."""
    rules_named(here, profile)
    content = file.file.read(here.settings.upload + 1)
    name = drawing_name(file.filename or "")
    return added(here, response, name, content, unit or "", profile, key)


def added(
    here: Service,
    response: Response | None,
    name: str,
    content: bytes,
    unit: str,
    profile: str,
    key: str | None = None,
) -> DrawingOut:
    """Read, classify and keep a drawing."""
    if len(content) > here.settings.upload:
        raise DrawingTooLarge(
            "drawing.upload-too-large", name=name, limit=here.settings.upload >> 20
        )
    rules = rules_named(here, profile)
    sha256 = hashlib.sha256(content).hexdigest()
    request = fingerprint(name, sha256, unit, profile)
    row = here.store.drawings.find(key, request) if key else None
    if row is None:
        interpretation = Interpretation(unit, profile, rules)
        reading = read(here, name, content, interpretation)
        row = here.store.drawings.add(
            name=name,
            content=content,
            sha256=sha256,
            interpretation=replace(interpretation, overrides=reading.overrides),
            summary=reading.summary,
            edges=reading.edges,
            ledger=reading.ledger,
            key=key,
            fingerprint=request,
        )
    drawing = drawing_out(here, row)
    if response is not None:
        response.headers["Location"] = f"/api/drawings/{row.id}"
        response.headers["ETag"] = _etag_of(drawing)
    return drawing


@router.get("")
def list_drawings(
    here: Here, response: Response, cursor: Cursor = None, limit: Limit = 100
) -> list[DrawingSummary]:
    """List drawings, the newest first; the Link header leads on."""
    rows = here.store.drawings.recent(cursor, limit)
    last = rows[-1].serial if len(rows) == limit else None
    next_page(response, "/api/drawings?", last, limit)
    return [summary_out(row) for row in rows]


@router.get("/{id}", response_model=DrawingOut, responses=_NOT_MODIFIED)
def get_drawing(
    here: Here, response: Response, id: str, known: IfNoneMatch = None
) -> DrawingOut | Response:
    """Look at a drawing."""
    row = here.store.drawings.get_with(id, "ledger")
    headers = {"ETag": etag(row.version, _state_of(here, row)), "Cache-Control": "no-cache"}
    if is_known(headers["ETag"], known):
        return Response(status_code=304, headers=headers)
    response.headers.update(headers)
    return drawing_out(here, row)


@router.patch("/{id}")
@queued
def change_drawing(
    here: Here, response: Response, id: str, patch: DrawingPatch, match: IfMatch = None
) -> DrawingOut:
    """Say a drawing's unit, or classify it by another profile, or by one as it was."""

    def decide(row: Drawing) -> _Decision:
        unit = row.unit_given
        if patch.unit is not None:
            unit = "" if patch.unit == "file" else patch.unit
        profile, rules = row.profile, row.rules
        if patch.rules:
            profile, rules = patch.profile or row.profile, patch.rules
            custom_profiles.check_name(profile)
            not_shipped(here, profile)
            custom_profiles.parse_text(profile, rules)
        elif patch.profile is not None:
            profile, rules = patch.profile, rules_named(here, patch.profile)
        why = f"unit {unit or 'open'}, profile {profile}"
        return _Decision(Interpretation(unit, profile, rules, row.overrides), why)

    return _changed(here, response, id, match, decide)


@router.delete("/{id}", status_code=204)
def delete_drawing(here: Here, id: str) -> None:
    """Forget a drawing that no job was made from."""
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
        return bytes_answer(request, row.edges, str(row.version), "application/octet-stream")
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
    """Give edges a line type; the later override lies on top."""

    def decide(row: Drawing) -> _Decision:
        overrides = overridden(row.edges, row.overrides, patch.overrides)
        why = f"{len(patch.overrides)} override{'s' * (len(patch.overrides) != 1)}"
        return _Decision(interpretation_of(row, overrides), why)

    return _changed(here, response, id, match, decide)


@router.get("/{id}/ledger")
def get_ledger(here: Here, id: str, fate: FateWord | None = None) -> LedgerOut:
    """List what became of every entity of the file, or only of those of one fate."""
    row = here.store.drawings.get_with(id, "ledger")
    rows = [one for one in _ledger(row) if fate in (None, one["fate"])]
    return LedgerOut.model_validate({**row.summary["ledger"], "rows": rows})


@router.get("/{id}/cleaning")
@queued
def get_cleaning(here: Here, id: str) -> CleaningOut:
    """List what cleaning makes of the edges before they are planned: joined, moved, dropped."""
    edges = here.store.drawings.column(id, "edges")
    return CleaningOut.model_validate(here.run(tasks.cleaned, edges))


@router.get("/{id}/file", response_class=Response, responses={200: BINARY})
def get_file(here: Here, request: Request, id: str) -> Response:
    """Return the file as it came."""
    row = here.store.drawings.get(id)
    content = here.store.drawings.column(id, "content")
    return bytes_answer(request, content, row.sha256, format_of(content).media_type, row.name)


def read(
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
        It cannot be read; the message begins with the drawing's name.
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
class _Decision:
    """What a change makes of a drawing."""

    interpretation: Interpretation
    why: str


def _changed(
    here: Service,
    response: Response,
    id: str,
    match: str | None,
    decide: Callable[[Drawing], _Decision],
) -> DrawingOut:
    """Change a drawing as was decided about its newest revision.

    Raises
    ------
    StaleRevision
        The request was made for another revision.
    WrongState
        The drawing is changed again and again meanwhile.
    """
    for _ in range(_TRIES):
        row = here.store.drawings.get_with(id, "content", "overrides", "edges")
        check_match(match, row)
        made = decide(row)
        handles = unpacked(row.edges)[1]["handles"]
        reading = read(here, row.name, row.content, made.interpretation, handles)
        kept = replace(made.interpretation, overrides=reading.overrides)
        try:
            changed = here.store.drawings.change(
                row.id,
                row.version,
                made.why,
                **drawing_columns(kept),
                summary=reading.summary,
                edges=reading.edges,
                ledger=reading.ledger,
            )
        except StaleRevision:
            # Who names no revision wants the change whatever else was changed meanwhile.
            if match is not None and match.strip() != "*":
                raise
            continue
        drawing = drawing_out(here, changed)
        response.headers["ETag"] = _etag_of(drawing)
        return drawing
    raise WrongState("drawing.changing", drawing=id)


def _etag_of(drawing: DrawingOut) -> str:
    return etag(drawing.revision, drawing.profile_state)


def overridden(block: bytes, before: bytes, overrides: Sequence[Override]) -> bytes:
    """Return a column of overrides with more of them laid on top.

    Parameters
    ----------
    block
        The drawing's edges, see ``columns``.
    before
        (n,) uint8, ``NO_OVERRIDE`` or a LineType.

    Raises
    ------
    RequestError
        One of them is about nothing.
    """
    columns, meta = unpacked(block)
    after = np.frombuffer(before, np.uint8).copy()
    rows_of: dict[str, list[int]] = {}
    if any(override.handles is not None for override in overrides):
        for row, handle in enumerate(meta["handles"]):
            rows_of.setdefault(handle, []).append(row)
    for override in overrides:
        value = NO_OVERRIDE if override.type is None else LineType.of(override.type)
        after[_chosen(override, columns, meta["layers"], rows_of, len(after))] = value
    return after.tobytes()


def _chosen(
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
    """Return a file's name without folders and signs that cannot be shown."""
    last = given.replace("\\", "/").rsplit("/", 1)[-1]
    shown = "".join(sign for sign in last if unicodedata.category(sign)[0] != "C").strip()
    if len(shown) > 120:
        stem, dot, suffix = shown.rpartition(".")
        shown = stem[:110] + dot + suffix[:9] if dot and stem else shown[:120]
    return shown or "drawing.dxf"


def edges_json(block: bytes) -> Iterator[bytes]:
    """Yield the JSON of ``EdgesOut`` in pieces: no call holds the interpreter for long."""
    columns, meta = unpacked(block)
    count = len(columns["ends"])
    # A block of an older knifetip does not say what became of the edges.
    unsaid = np.zeros(count, np.int32)
    columns = {"fate": unsaid, "reason": unsaid, **columns}
    meta = {"fates": ["kept"], "reasons": [""], "alternatives": [], **meta}
    yield b'{"edges":['
    for first in range(0, count, _PIECE):
        rows = _edge_rows(columns, meta, first, min(first + _PIECE, count))
        text = json.dumps(rows, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
        yield (("," if first else "") + text[1:-1]).encode()
    yield b"]}"


def _edge_rows(
    columns: dict[str, Any], meta: dict[str, Any], first: int, last: int
) -> list[dict[str, Any]]:
    """Return edges ``first`` … ``last - 1`` as plain data (``EdgeOut``)."""
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
            "fate": meta["fates"][listed["fate"][at]],
            "reason": meta["reasons"][listed["reason"][at]],
            "length": listed["length"][at],
            "start": start,
            "end": end,
            "bulge": listed["bulge"][at],
        }
        for at, (start, end) in enumerate(listed["ends"])
    ]


def _ledger(row: Drawing, most: int | None = None) -> list[dict[str, Any]]:
    """Return the rows of a drawing's ledger, or only so many of them."""
    text = zlib.decompress(row.ledger).decode()
    rows: list[dict[str, Any]] = json.loads(text) if most is None else _first(text, most)
    return rows


def _first(text: str, most: int) -> list[dict[str, Any]]:
    """Return the first elements of a JSON list, without reading the others."""
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
    """Return a drawing, read with its ledger, as the API shows it."""
    ledger = row.summary["ledger"]
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
            "profile_state": _state_of(here, row),
            "rules": row.rules,
            "unit_given": row.unit_given or None,
            "ledger": {**ledger, "rows": _ledger(row, _LISTED)},
        }
    )


def _state_of(here: Service, row: Drawing) -> str:
    """Return whether the profile still says what it said when the drawing was classified by it."""
    kept = here.store.profiles.get(row.profile)
    if kept is None:
        return "deleted" if row.rules else "current"
    return "current" if kept.text == row.rules else "changed"


def summary_out(row: Drawing) -> DrawingSummary:
    """Return a drawing as a list shows it."""
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
