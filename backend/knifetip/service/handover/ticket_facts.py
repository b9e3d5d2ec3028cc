"""ticket_facts: collect what the ticket of a job states from the database and the library."""

from __future__ import annotations

from typing import Any, NamedTuple
from urllib.parse import quote

import numpy as np

from knifetip.errors import KnifetipError
from knifetip.handover.ticket.facts import Accepted, TicketFacts
from knifetip.messages import from_json
from knifetip.model.board import Board
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.machine import Machine
from knifetip.planning.registration import describe_registration
from knifetip.presentation.columns import unpack_columns
from knifetip.service.components import Service
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.handover.tasks import JobData


class TicketData(NamedTuple):
    """The data of a ticket, for ``tasks.write_ticket``."""

    facts: TicketFacts
    edges: bytes
    job: JobData


def ticket_data(service: Service, id: str, address: str) -> TicketData:
    """Return the data of the ticket of a job.

    Parameters
    ----------
    id
        Id of the job.
    address
        URL of the page of the server, without a fragment.

    Raises
    ------
    NotFound
        There is no job with this id.
    """
    row = service.store.jobs.get(id)
    toolpath, verdict = _value(service, row, "toolpath"), _value(service, row, "verdict")
    overrides = _value(service, row, "overrides") or b""
    drawing = service.store.drawings.get_with(row.drawing, "edges", "overrides")
    machine, board = _machine(service, row), _board(service, row)
    sheet = row.options.sheet
    facts = TicketFacts(
        job=row.id,
        state=row.state,
        printed=service.store.database.clock(),
        address=f"{address}/#/station/{quote(row.machine, safe='')}",
        order=row.external_id,
        customer=row.customer,
        due=row.due,
        notes=row.notes,
        drawing=row.drawing_name,
        revision=drawing.version,
        is_changed=_is_changed(row, overrides, drawing),
        machine=(machine and machine.title) or row.machine,
        board=(board and board.title) or row.board,
        caliper=None if board is None else board.caliper,
        sheet=None if sheet is None else sheet.size,
        margins=(0.0, 0.0) if sheet is None else sheet.margins,
        corner=_corner(row, toolpath, drawing),
        copies=row.copies,
        seconds=row.seconds,
        lines=row.lines,
        summary=row.verdict_summary,
        accepted=_accepted(verdict),
        registration=describe_registration(row.options),
    )
    return TicketData(facts, drawing.edges, JobData(overrides, toolpath, row.tools, machine))


def _value(service: Service, row: Job, column: str) -> bytes | None:
    """Return a large value of a job; None if the job has none."""
    if getattr(row, f"{column}_address") is None:
        return None
    return service.store.jobs.column(row.id, column)


def _is_changed(row: Job, overrides: bytes, drawing: Drawing) -> bool:
    """Return whether a drawing was read or classified otherwise since a job was ordered.

    Line types that the order itself has set are no change.
    """
    if drawing.layout is not None:
        return drawing.updated > row.created
    names = ("unit_given", "learned")
    if any(getattr(row, name) != getattr(drawing, name) for name in names):
        return True
    present = np.frombuffer(drawing.overrides or b"", np.uint8)
    ordered = np.frombuffer(overrides, np.uint8)
    if len(present) != len(ordered):
        return bool(np.any(present != NO_OVERRIDE))
    return bool(np.any((present != NO_OVERRIDE) & (present != ordered)))


def _machine(service: Service, row: Job) -> Machine | None:
    """Return the machine for which a job is compiled; None if it cannot be used any more."""
    try:
        return service.store.library.machine(row.machine, row.machine_version)
    except KnifetipError:
        return None


def _board(service: Service, row: Job) -> Board | None:
    """Return the board for which a job is compiled; None if it cannot be used any more."""
    try:
        return service.store.library.board(row.board, row.board_version)
    except KnifetipError:
        return None


def _corner(row: Job, toolpath: bytes | None, drawing: Drawing) -> tuple[float, float] | None:
    """Return where the sheet of a job, or else its drawing, begins on the table (mm).

    None if the job is not compiled, because the place follows from the program, or if it lies by
    measured marks.
    """
    bounds = drawing.summary.get("bounds")
    if toolpath is None or not bounds:
        return None
    meta = unpack_columns(toolpath)[1]
    if meta.get("similarity") is not None:
        return None  # the sheet lies by its marks
    placement = meta["placement"]
    sheet = row.options.sheet
    left, below = (0.0, 0.0) if sheet is None or sheet.size is None else sheet.margins
    return bounds[0] + placement[0] - left, bounds[1] + placement[1] - below


def _accepted(verdict: bytes | None) -> tuple[Accepted, ...]:
    """Return the accepted shortfalls of a stored verdict."""
    if verdict is None:
        return ()
    rows: list[dict[str, Any]] = unpack_columns(verdict)[1]["findings"]
    return tuple(
        Accepted(from_json(row), given["by"], given["at"], given["reason"])
        for row in rows
        if (given := row.get("acceptance")) is not None
    )
