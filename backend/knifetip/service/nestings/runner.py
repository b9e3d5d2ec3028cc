"""runner: execute nestings in threads of the server, whose engines are processes of their own."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Sequence
from typing import Any, Final

from knifetip.errors import KnifetipError, ServerBusy
from knifetip.messages import Message
from knifetip.model.nesting import NestingJob
from knifetip.nesting.job import layouts_of, problem_of
from knifetip.nesting.parts import Part
from knifetip.nesting.problem import check_sizes
from knifetip.nesting.search import Found, nest
from knifetip.service.nestings.store import NestingState, NestingStore
from knifetip.service.nestings.tables import Nesting

#: Nestings that one server executes at once; each occupies one core.
AT_ONCE: Final = 2
_RETRY: Final = 10  # seconds after which a client may try again
_RENEW: Final = 1.0  # seconds between two renewals of a lease
_log = logging.getLogger("knifetip.jobs")


class NestingRunner:
    """Threads that search for arrangements, and store the best ones.

    Parameters
    ----------
    store
        Repository of nestings.
    """

    def __init__(self, store: NestingStore) -> None:
        self._store = store
        self._stopping = threading.Event()
        self._lock = threading.Lock()
        self._threads: set[threading.Thread] = set()

    def begin(self, job: NestingJob, parts: Sequence[Part], revisions: Sequence[int]) -> Nesting:
        """Begin a nesting, and return it.

        Parameters
        ----------
        job, parts, revisions
            The job, and shape and revision of the drawing of each of its parts.

        Raises
        ------
        ServerBusy
            This server executes ``AT_ONCE`` nestings.
        PlanError
            The margins leave no room on the sheet, or a part fits on no sheet.
        """
        check_sizes(problem_of(job, parts))
        with self._lock:
            if len(self._threads) >= AT_ONCE:
                raise ServerBusy(waiting=AT_ONCE, seconds=_RETRY)
            row = self._store.add(job.model_dump(mode="json"))
            thread = threading.Thread(
                target=self._run, args=(row.id, job, parts, revisions), name="nesting", daemon=True
            )
            self._threads.add(thread)
        thread.start()
        return row

    def stop(self) -> None:
        """End all nestings, because the server stops; they are *interrupted*."""
        self._stopping.set()
        with self._lock:
            threads = tuple(self._threads)
        for thread in threads:
            thread.join()

    def _run(
        self, id: str, job: NestingJob, parts: Sequence[Part], revisions: Sequence[int]
    ) -> None:
        try:
            self._search(id, job, parts, revisions)
        except KnifetipError as reason:
            self._store.end(id, NestingState.FAILED, reason.message)
        except Exception:
            _log.exception("nesting %s failed", id)
            self._store.end(id, NestingState.FAILED, Message("nesting.failed"))
        finally:
            with self._lock:
                self._threads.discard(threading.current_thread())

    def _search(
        self, id: str, job: NestingJob, parts: Sequence[Part], revisions: Sequence[int]
    ) -> None:
        lease = _Lease(self._store, id)

        def report(found: Found) -> None:
            lease.result = result_json(found, job, parts, revisions)

        def stopped() -> bool:
            return self._stopping.is_set() or not lease.goes_on()

        nest(problem_of(job, parts), report, stopped)
        goes_on = lease.renew()
        if self._stopping.is_set():
            state = NestingState.INTERRUPTED
        else:
            state = NestingState.DONE if goes_on else NestingState.STOPPED
        self._store.end(id, state)


class _Lease:
    """The lease of a running nesting, which is renewed about once per second.

    ``result`` is the best arrangement that is not stored yet.
    """

    def __init__(self, store: NestingStore, id: str) -> None:
        self._store = store
        self._id = id
        self._renewed = 0.0
        self._goes_on = True
        self.result: dict[str, Any] | None = None

    def goes_on(self) -> bool:
        """Return False if the nesting was stopped or deleted."""
        if time.monotonic() - self._renewed > _RENEW:
            self.renew()
        return self._goes_on

    def renew(self) -> bool:
        """Store the best arrangement; return False if the nesting was stopped or deleted."""
        self._renewed = time.monotonic()
        result, self.result = self.result, None
        self._goes_on = self._store.renew(self._id, result)
        return self._goes_on


def result_json(
    found: Found, job: NestingJob, parts: Sequence[Part], revisions: Sequence[int]
) -> dict[str, Any]:
    """Return an arrangement as JSON data; the parameters are those of ``NestingRunner.begin``."""
    areas = [part.area.area for part in parts]
    layouts = layouts_of(found.arrangement, job, revisions)
    return {
        "seconds": round(found.seconds, 3),
        "use": round(found.use, 2),
        "rectangles_use": round(found.columns_use, 2),
        "in_holes": found.in_holes,
        "sheets": [
            {
                **layout.model_dump(mode="json"),
                "use": round(
                    100.0
                    * sum(areas[place.part] for place in sheet.places)
                    / (sheet.board.width * sheet.board.height),
                    2,
                ),
            }
            for layout, sheet in zip(layouts, found.arrangement.sheets, strict=True)
        ],
    }
