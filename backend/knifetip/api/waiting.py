"""What a job waits for: a field for programs, reason and hint for the operator.

    job rows + queues of their machines -> waiting_for, reason, hint

``waiting_for`` is one of

- ``confirmation``: the operator must confirm table, board and tools before the first line,
- ``sheet``: the operator must confirm the sheet of the next copy,
- ``machine``: the job is next, but its machine has not claimed it,
- ``turn``: other jobs of the machine come first,
- empty: the job does not wait.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from knifetip.errors import LibraryError
from knifetip.jobs.gateway_store import Queue
from knifetip.jobs.job import Confirmation, State
from knifetip.jobs.store import Store
from knifetip.jobs.tables import Job
from knifetip.languages.registry import find_language
from knifetip.library import load

WaitingFor = Literal["", "confirmation", "sheet", "machine", "turn"]

#: Seconds without a request after which a gateway counts as absent.
ABSENT = 6.0


class Waiting(NamedTuple):
    """What a job waits for."""

    waiting_for: WaitingFor = ""
    reason: str = ""
    hint: str = ""


def waiting_of(store: Store, jobs: Sequence[Job]) -> list[Waiting]:
    """Return what each job waits for; queries the store only if a job is queued."""
    machines = {row.machine for row in jobs if row.state == State.QUEUED}
    queues = store.gateways.queues(machines, ABSENT) if machines else {}
    return [_waiting(row, queues.get(row.machine)) for row in jobs]


def _waiting(row: Job, queue: Queue | None) -> Waiting:
    if row.confirmation == Confirmation.AWAITED:
        return _to_confirm(row)
    if row.confirmation == Confirmation.SHEET:
        return Waiting(
            "sheet",
            f"Copy {row.copies_done} of {row.copies} is done.",
            f"Put a new sheet of {board_in_words(row.board)} on the table and confirm.",
        )
    if row.state == State.QUEUED and queue is not None:
        return _queued(row, queue)
    return Waiting()


def _to_confirm(row: Job) -> Waiting:
    place = f"board {board_in_words(row.board)}"
    if row.tools:
        tools = ", ".join(f"{one['name']} (station {one['station']})" for one in row.tools)
        place += f", tools: {tools}"
    if row.state == State.QUEUED:
        return Waiting(
            "confirmation",
            f"Waiting for the operator at {_title(row.machine)}: table clear, {place}.",
            "Confirm to start.",
        )
    return Waiting(
        "confirmation",
        f"{_title(row.machine)} was started without the operator's confirmation: {place}.",
        "Look at the table. Confirm to let the job go on, or cancel it.",
    )


def _queued(row: Job, queue: Queue) -> Waiting:
    title = _title(row.machine)
    if row.confirmation == Confirmation.GIVEN:
        return Waiting("machine", f"Confirmed; {title} is starting.")
    if row.id != queue.first:
        return Waiting("turn", f"Waiting for its turn at {title}; other jobs come first.")
    if queue.ahead:
        reason = f"{title} is taken by job {queue.ahead}, which is {queue.ahead_state}."
        if queue.ahead_state == State.INTERRUPTED:
            hint = "Mark that job finished, queue it again or scrap it first."
            return Waiting("machine", reason, hint)
        if queue.ahead_state == State.QUEUED:
            reason = f"{title} is taken by job {queue.ahead}, which waits for its confirmation."
        return Waiting("machine", reason)
    if not queue.connected:
        return Waiting(
            "machine",
            f"No gateway of {title} asks for work.",
            _how_to_connect(row.machine),
        )
    return Waiting("machine", f"Waiting until {title} takes it.")


def _how_to_connect(machine: str) -> str:
    try:
        language = find_language(load.machine(machine, files=False).dialect)
    except LibraryError:
        return "Switch on the machine and its gateway."
    return language.no_driver or "Switch on the machine and its gateway."


def _title(machine: str) -> str:
    try:
        return load.machine(machine, files=False).title
    except LibraryError:
        return machine


def board_in_words(board: str) -> str:
    """Return a board's name and caliper; the name alone where the library has it no more."""
    try:
        return f"{board} ({load.board(board, files=False).caliper:g} mm)"
    except LibraryError:
        return board
