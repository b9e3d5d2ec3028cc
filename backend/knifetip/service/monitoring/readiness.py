"""Readiness of a server: a real write, free disk space, contents, workers and tables (ADR 84)."""

from __future__ import annotations

import asyncio
import logging
import sqlite3
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Final

import sqlalchemy.exc

from knifetip.errors import StoreError
from knifetip.service.compiling.service import CompileService
from knifetip.service.database.damage import is_damaged, is_disk_full
from knifetip.service.database.write_probe import write_probe
from knifetip.service.limits.disk_space import OK, Storage
from knifetip.service.limits.threads import GatewayThreads
from knifetip.service.store import Store

#: Seconds for which the result of a check is cached; many probes may send requests every second.
_KEEP: Final = 3.0
#: The same for contents outside the database: each check writes, and a bucket charges for it.
_KEEP_CONTENTS: Final = 30.0
#: Time limit for an answer of the database, and for one of the folder or bucket (s).
_PATIENCE: Final = 10.0
#: Seconds between two checks of all pages of an SQLite database.
_KEEP_DAMAGE: Final = 600.0
_SILENT: Final = 120.0  # seconds without a sweep after which the compile service is stuck

_DAMAGED: Final = "damaged"

_Results = dict[str, str]
_log = logging.getLogger("knifetip.api")


class _Check:
    """A check whose result is kept for some seconds, and which never runs twice at once.

    Parameters
    ----------
    run
        Runs the check; returns "ok" or the fault of each component.
    component
        Component that has the fault if the check does not end in time.
    keep
        Time for which a result is kept (s).
    clock
        Seconds of a clock that does not jump.
    """

    def __init__(
        self,
        run: Callable[[], Awaitable[_Results]],
        component: str,
        keep: float,
        clock: Callable[[], float],
    ) -> None:
        self._run = run
        self._component = component
        self._keep = keep
        self._clock = clock
        self._lock = asyncio.Lock()
        self._checked = float("-inf")
        self._results: _Results = {}
        self._running: asyncio.Future[_Results] | None = None

    async def results(self) -> _Results:
        """Return the results, which may be some seconds old."""
        async with self._lock:
            if self._clock() - self._checked >= self._keep:
                # A check that hangs, because the database or a disk does, occupies a thread: there
                # is never a second one.
                if self._running is None or self._running.done():
                    self._running = asyncio.ensure_future(self._run())
                done, _ = await asyncio.wait((self._running,), timeout=_PATIENCE)
                self._results = self._running.result() if done else {self._component: "no answer"}
                self._checked = self._clock()
            return self._results


class DamageWatch:
    """Checks from time to time, in a thread of its own, whether the database file is damaged.

    A check reads the whole file, so that ``fault`` returns the result of the last one and never
    waits.

    Parameters
    ----------
    store
        Store with the database.
    clock
        Seconds of a clock that does not jump.
    """

    def __init__(self, store: Store, clock: Callable[[], float]) -> None:
        self._store = store
        self._clock = clock
        self._due = float("-inf")
        self._fault = OK
        self._running: asyncio.Task[None] | None = None

    def report(self) -> None:
        """Record that the database has refused a request because it is damaged."""
        self._fault, self._due = _DAMAGED, float("-inf")

    def fault(self) -> str:
        """Return "ok" or "damaged", and begin the next check if it is due."""
        is_idle = self._running is None or self._running.done()
        if is_idle and self._clock() >= self._due:
            self._due = self._clock() + _KEEP_DAMAGE
            self._running = asyncio.create_task(self._check(), name="database check")
        return self._fault

    async def ended(self) -> None:
        """Return when the running check has ended."""
        if self._running is not None:
            await self._running

    async def _check(self) -> None:
        try:
            found = await asyncio.to_thread(self._store.database.damage)
        except sqlite3.Error as reason:
            _log.warning("the database file cannot be checked: %s", reason)
            return
        if found and self._fault == OK:
            _log.error("the database is damaged: %s", found)
        self._fault = _DAMAGED if found else OK


@dataclass(slots=True)
class Readiness:
    """The checks of a server; their results are kept for some seconds."""

    store: Store
    storage: Storage
    compiling: CompileService
    threads: GatewayThreads
    clock: Callable[[], float] = time.monotonic
    _fast: _Check = field(init=False)
    _contents: _Check = field(init=False)
    damage: DamageWatch = field(init=False)

    def __post_init__(self) -> None:
        # Runs in the threads of heartbeats, which also wait for the database.
        run = partial(self.threads.reports, self._check)
        self._fast = _Check(run, "database", _KEEP, self.clock)
        self.damage = DamageWatch(self.store, self.clock)
        # Runs in another thread: a bucket that is silent for minutes must not stop heartbeats.
        outside = partial(asyncio.to_thread, self._check_contents)
        self._contents = _Check(outside, "contents", _KEEP_CONTENTS, self.clock)

    async def checks(self) -> _Results:
        """Return "ok" or the fault of each component."""
        fast, contents = await asyncio.gather(self._fast.results(), self._contents.results())
        damage = self.damage.fault()
        found = fast if damage == OK else fast | {"database": damage}
        return found | contents | {"workers": self._workers()}

    def _check(self) -> _Results:
        return {
            "database": self._database(),
            "schema": self._schema(),
            "disk": self.storage.fault(),
        }

    def _check_contents(self) -> _Results:
        try:
            self.store.contents.probe()
        except (StoreError, OSError) as reason:
            # The address of a bucket is not for strangers, who may call /readyz.
            _log.warning("readiness: %s", reason)
            return {"contents": "not usable"}
        return {"contents": OK}

    def _database(self) -> str:
        try:
            write_probe(self.store.database)
        except sqlalchemy.exc.SQLAlchemyError as reason:
            if is_damaged(reason):
                return _DAMAGED
            return "disk full" if is_disk_full(reason) else type(reason).__name__
        return OK

    def _schema(self) -> str:
        try:
            schema = self.store.database.schema()
        except (sqlalchemy.exc.SQLAlchemyError, StoreError) as reason:
            return type(reason).__name__
        if schema.is_current:
            return OK
        return f"revision {schema.revision or 'none'}, {schema.newest} needed"

    def _workers(self) -> str:
        silent = self.compiling.seconds_since_sweep
        if silent is None:
            return "starting"
        return OK if silent < _SILENT else f"silent for {silent:.0f} s"
