"""The reason why a job waits: a field for programs and a message for the operator.

The field ``waiting_for`` is one of

- ``confirmation``: the operator must confirm table, board and tools before the first program line,
- ``sheet``: the operator must confirm the sheet of the next copy,
- ``machine``: the job is next, but its machine has not claimed it,
- ``turn``: other jobs of the machine come first,
- ``hold``: an operator put the job on hold in the queue,
- ``check``: the machine has refused the program; an operator decides what follows,
- ``compile``: the machine or the board has changed, so the job must be compiled again,
- empty: the job does not wait.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from knifetip.contract.job import Confirmation, State
from knifetip.errors import LibraryError
from knifetip.languages.language import Language
from knifetip.languages.registry import find_language
from knifetip.messages import Message
from knifetip.service.database.tables import Job
from knifetip.service.library.store import LibraryStore
from knifetip.service.lifecycle.machine_queues import Queue
from knifetip.service.machines.station_store import StationView
from knifetip.service.store import Store

WaitingFor = Literal["", "confirmation", "sheet", "machine", "turn", "hold", "check", "compile"]

#: Seconds without a request after which a gateway counts as absent.
ABSENT = 6.0


class WaitReason(NamedTuple):
    """The reason why a job waits, as a field for programs and as a message for the operator."""

    waiting_for: WaitingFor = ""
    message: Message | None = None


def waiting_of(store: Store, jobs: Sequence[Job]) -> list[WaitReason]:
    """Return the reasons why jobs wait, one per job; queries the store only if a job is queued."""
    machines = {row.machine for row in jobs if row.state == State.QUEUED}
    queues = store.machines.queues(machines, ABSENT) if machines else {}
    stations = store.stations.views(machines) if machines else {}
    changes = store.library.changes([row for row in jobs if _can_be_outdated(row)])
    return [
        WaitReason("compile", Message("waiting.outdated", changes=changes[row.id]))
        if row.id in changes
        else _waiting(store, row, queues.get(row.machine), stations.get(row.machine))
        for row in jobs
    ]


def _can_be_outdated(row: Job) -> bool:
    """Return whether a job waits for a start that is refused if its machine or board changes."""
    return row.state in (State.READY, State.QUEUED) or row.confirmation == Confirmation.SHEET


def _waiting(
    store: Store, row: Job, queue: Queue | None, station: StationView | None
) -> WaitReason:
    library = store.library
    if row.confirmation == Confirmation.AWAITED:
        machine, board = library.titles(row)
        code = "waiting.for-start" if _is_copy_unsent(row) else "waiting.unconfirmed-run"
        details = [_sheet_message(row), _tools_message(row)]
        given: dict[str, str | None] = {}
        if row.rest is not None and _is_copy_unsent(row):
            code, given = "waiting.for-rest", {"job": row.resumes}
        elif _is_copy_unsent(row):
            details.append(_unfinished_sheet_message(store.gateways.unfinished_sheet(row)))
        found = [detail for detail in details if detail is not None]
        message = Message(code, machine=machine, board=board, details=found, **given)
        return WaitReason("confirmation", message)
    if row.confirmation == Confirmation.SHEET:
        message = Message(
            "waiting.for-sheet",
            copy=row.copies_done,
            copies=row.copies,
            board=library.titles(row)[1],
            sheet=_sheet_message(row),
        )
        return WaitReason("sheet", message)
    if row.state == State.HELD and row.awaits_end:
        return WaitReason("", Message("waiting.for-end", machine=library.titles(row)[0]))
    if row.state == State.QUEUED and queue is not None:
        return _queued(library, row, queue, station)
    return WaitReason()


def _is_copy_unsent(row: Job) -> bool:
    """Return whether nothing of the present copy of a job was sent to its machine."""
    return row.state == State.QUEUED or (row.state == State.HELD and row.line == 0)


def _unfinished_sheet_message(job: str) -> Message | None:
    """Return a message about the unfinished sheet of a job; None for "" (there is none)."""
    return Message("waiting.unfinished-sheet", job=job) if job else None


def _sheet_message(row: Job) -> Message | None:
    """Return a message with the size of a job's sheet; None if the sheet was not cut to size."""
    sheet = row.options.sheet
    if sheet is None:
        return None
    if sheet.size is None:
        return Message("waiting.sheet-outline")
    return Message("waiting.sheet-size", width=sheet.size[0], height=sheet.size[1])


def _tools_message(row: Job) -> Message | None:
    """Return a message that lists the stations which a job's program uses; None if it uses none."""
    tools = [
        Message("waiting.tool", name=tool["name"], station=tool["station"]) for tool in row.tools
    ]
    return Message("waiting.tools", tools=tools) if tools else None


def _queued(
    library: LibraryStore, row: Job, queue: Queue, station: StationView | None
) -> WaitReason:
    title, _ = library.titles(row)
    if row.confirmation == Confirmation.GIVEN:
        return WaitReason("machine", Message("waiting.confirmed", machine=title))
    if row.check_refusal is not None:
        refused = Message("waiting.check-refused", machine=title, reason=row.check_refusal)
        return WaitReason("check", refused)
    if row.on_hold:
        return WaitReason("hold", Message("waiting.on-hold", machine=title))
    if row.id != queue.first:
        taken = queue.ahead and _occupied_message(title, queue)
        return WaitReason("turn", taken or Message("waiting.for-turn", machine=title))
    if queue.ahead:
        return WaitReason("machine", _occupied_message(title, queue))
    if station is not None and station.alive:
        obstacle = _obstacle(station, title)
        return WaitReason("machine", obstacle or Message("waiting.for-machine", machine=title))
    if not queue.connected:
        return WaitReason("machine", _no_gateway(library, row, title))
    return WaitReason("machine", Message("waiting.for-machine", machine=title))


def _obstacle(station: StationView, title: str) -> Message | None:
    """Return why a machine whose gateway is connected takes no job; None if it is free."""
    row = station.row
    if not row.connected:
        reason = row.notices[0] if row.notices else None
        code = "waiting.for-controller" if reason is None else "waiting.controller-not-connected"
        return Message(code, machine=title, **({} if reason is None else {"reason": reason}))
    reason = row.alarm or row.obstacle
    return None if reason is None else Message("waiting.obstacle", machine=title, reason=reason)


def _occupied_message(title: str, queue: Queue) -> Message:
    """Return the message that a machine is occupied by another job.

    ``queue``: state of the queue of the machine; its field ``ahead`` is the id of the other job.
    """
    match queue.ahead_state:
        case State.INTERRUPTED:
            return Message("waiting.taken-interrupted", machine=title, job=queue.ahead)
        case State.QUEUED:
            return Message("waiting.taken-unconfirmed", machine=title, job=queue.ahead)
        case state:
            return Message("waiting.taken", machine=title, job=queue.ahead, state=state)


def _no_gateway(library: LibraryStore, row: Job, title: str) -> Message:
    """Return the message that a job waits because no gateway of its machine is connected."""
    language = language_of(library, row)
    if language and language.no_driver:
        return Message("waiting.for-person", machine=title, advice=language.no_driver)
    return Message("waiting.for-gateway", machine=title)


def language_of(library: LibraryStore, row: Job) -> Language | None:
    """Return the controller language of a job's machine; None if the library lacks the machine."""
    try:
        return find_language(library.machine(row.machine, row.machine_version).dialect)
    except LibraryError:
        return None
