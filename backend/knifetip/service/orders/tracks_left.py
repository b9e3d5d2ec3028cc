"""Number of tracks that are left on the sheet of an interrupted job, for the hint of the job."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from knifetip.contract.job import State
from knifetip.errors import KnifetipError
from knifetip.messages import Message
from knifetip.presentation.toolpath import unpack_toolpath
from knifetip.sequencing.tracks import TrackState
from knifetip.service.database.tables import Job
from knifetip.service.orders.operator_actions import OperatorAction, allowed_actions
from knifetip.service.runs.stop_place import executed_at_most
from knifetip.service.store import Store

#: Counts that are kept for a store: a machine has one interrupted job, which pages read often.
_KEPT = 256
#: Least and most tracks that are left, by id of the job, checksum of its program, and lines.
_Key = tuple[str, str, int, int]
_counts: WeakKeyDictionary[Store, dict[_Key, tuple[int, int]]] = WeakKeyDictionary()


def first_advice(store: Store, row: Job, message: Message | None, now: float) -> Message | None:
    """Return the message about a job with the best way after an interruption first in its hint.

    That is to continue the sheet, with the number of its tracks that are left.  The message is
    returned as it is if the job is not interrupted, or nothing is left of its sheet.

    Parameters
    ----------
    store
        Store of the job, for its tracks.
    row
        The job.
    message
        The message about its state; None if there is none.
    now
        Present time (seconds since 1970).
    """
    if message is None or row.state != State.INTERRUPTED:
        return message
    # Between two copies a sheet is complete, and nothing of the next one is made.
    between = message.code == "job.interrupted-between-copies"
    if between or OperatorAction.REST not in allowed_actions(row, now):
        return message
    least, most = _tracks_left(store, row)
    if not most:
        return message
    tracks = Message("rest.tracks", count=most)
    if least < most:
        tracks = Message("rest.tracks-between", least=least, most=most)
    return Message("rest.continue-first", tracks=tracks, interruption=message)


def _tracks_left(store: Store, row: Job) -> tuple[int, int]:
    """Return the least and the most tracks that are left on the sheet; 0 if they are not stored."""
    counts = _counts.setdefault(store, {})
    most_lines = executed_at_most(row)
    key = row.id, row.program_sha256, row.line, most_lines
    if key not in counts:
        try:
            _, tracks = unpack_toolpath(store.jobs.column(row.id, "toolpath"))
        except KnifetipError:  # of an older version, or lost: the advice is then without it
            return 0, 0
        states = tracks.states(row.line, most_lines)
        left = sum(state is not TrackState.CUT for state in states)
        if len(counts) >= _KEPT:
            counts.clear()
        counts[key] = left - sum(state is TrackState.UNKNOWN for state in states), left
    return counts[key]
