"""Routes to continue the work of a job: its tracks, and a job that makes the rest or a copy."""

from __future__ import annotations

from bisect import bisect_right

import numpy as np
from fastapi import Response

from knifetip.model.acceptance import Exceptions
from knifetip.model.verdict import Acceptance
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.toolpath import unpack_toolpath
from knifetip.sequencing.tracks import RestChoice, select_rest
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.request_key import RequestKey, fingerprint
from knifetip.service.database.tables import Job
from knifetip.service.http.parameters import IdempotencyKey, JobId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.rest_models import RestIn, TrackOut
from knifetip.service.orders.store import Continuation
from knifetip.service.processes.rest_record import ExecutedWork, Ranges, RestRecord
from knifetip.service.runs.stop_place import executed_at_most

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.get("/{id}/tracks")
@requires(AccessScope.VIEWER)
def get_tracks(service: ServiceDep, id: JobId) -> list[TrackOut]:
    """List the tracks of a job's program in their order, and which of them are cut.

    A track is a path of one tool between two lifts.  The states are those of the last copy that was
    begun, according to the last program line that the machine reported.
    """
    row = service.store.jobs.get(id)
    path, tracks = unpack_toolpath(service.store.jobs.column(id, "toolpath"))
    states = tracks.states(row.line, executed_at_most(row))
    result = []
    for number, state in enumerate(states):
        first, last = int(tracks.first_row[number]), int(tracks.last_row[number])
        edges = np.unique(path.source[first : last + 1])
        start, end = path.pose[first, :2].tolist(), path.pose[last + 1, :2].tolist()
        result.append(
            TrackOut(
                number=number + 1,
                station=int(tracks.station[number]),
                stage=bisect_right(path.stages, number),
                first_line=int(tracks.first_line[number]),
                last_line=int(tracks.last_line[number]),
                edges=edges[edges >= 0].tolist(),
                start=(start[0], start[1]),
                end=(end[0], end[1]),
                state=state.value,
            )
        )
    return result


@router.post("/{id}/rest", status_code=201)
@requires(AccessScope.OPERATOR)
def continue_job(
    service: ServiceDep,
    response: Response,
    id: JobId,
    choice: RestIn,
    key: IdempotencyKey = None,
) -> JobOut:
    """Create a job that makes the rest of the sheet of another job, or the whole program again.

    The other job must have ended or be interrupted.  The program of the new job makes tracks of the
    other program in their order; it is verified against what is still uncut, and the other tracks
    must not be made again.  If the machine may have executed more lines than it reported
    (``stopped_at.certain`` of the other job is false), `made` must list the tracks that the
    operator has found complete; otherwise the status is 422 (``rest.statement-needed``).  Its
    program is refused if it works on a piece of board that executed lines have cut out, also where
    it makes their tracks again, unless `uncut` is set.  When the new job is queued, an interrupted
    job becomes ``continued`` and frees its table.  The operator must confirm the new job on every
    machine before it starts.  The status is 409 if the other job is on its machine, if a third job
    continues its sheet, or if no copies remain to be made.
    """
    request = RequestKey(key, fingerprint(id, choice.model_dump_json())) if key else None
    row = service.store.jobs.find(request) if request else None
    if row is None:
        parent = service.store.jobs.get(id)
        continuation = Continuation(
            None if choice.whole or choice.remaining else _rest_record(service, parent, choice),
            parent.line,
            None if choice.remaining else choice.copies,
            choice.release,
            _accepted_exceptions(service, parent),
        )
        row = service.store.jobs.add_continuation(id, continuation, request)
    response.headers["Location"] = f"/api/jobs/{row.id}"
    return job_out(service.store, row)


def _rest_record(service: Service, parent: Job, choice: RestIn) -> RestRecord:
    """Return the work that remains on the sheet of a job according to a request."""
    _, tracks = unpack_toolpath(service.store.jobs.column(parent.id, "toolpath"))
    selected = select_rest(
        tracks,
        parent.line,
        RestChoice(
            choice.from_track,
            choice.from_line,
            choice.station,
            choice.made if isinstance(choice.made, bool) else tuple(choice.made),
            choice.uncut,
        ),
        parent.id,
        executed_at_most(parent),
    )
    earlier = () if parent.rest is None else RestRecord.from_json(parent.rest).made
    ends = np.flatnonzero(np.diff(selected.tracks) != 1)
    first = selected.tracks[np.concatenate([[0], ends + 1])].tolist()
    last = selected.tracks[np.concatenate([ends, [len(selected.tracks) - 1]])].tolist()
    ranges: Ranges = tuple(zip(first, last, strict=True))
    work = ExecutedWork(parent.id, selected.made_lines, selected.repeated_lines)
    return RestRecord(ranges, (*earlier, work))


def _accepted_exceptions(service: Service, parent: Job) -> Exceptions | None:
    """Return the shortfalls that a user accepted in the verdict on a job; None if there are none.

    They have the latest of their acceptances.
    """
    if not (parent.verdict_summary or {}).get("exceptions"):
        return None
    findings = unpack_columns(service.store.jobs.column(parent.id, "verdict"))[1]["findings"]
    accepted = [row for row in findings if row.get("acceptance")]
    latest = max((Acceptance(**row["acceptance"]) for row in accepted), key=lambda one: one.at)
    return Exceptions(tuple(sorted({(row["edge"], row["code"]) for row in accepted})), latest)
