"""Readiness of a server: a real write, free disk space, workers and tables (ADR 84)."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

import sqlalchemy.exc

from knifetip.api.storage import OK, Storage
from knifetip.api.threads import GatewayThreads
from knifetip.errors import StoreError
from knifetip.jobs.compile_service import CompileService
from knifetip.jobs.store import Store
from knifetip.jobs.write_probe import is_disk_full, write_probe

#: Seconds for which the result of a check is cached; many probes may send requests every second.
_KEEP: Final = 3.0
#: Time limit for an answer of the database (s).
_PATIENCE: Final = 10.0
_SILENT: Final = 120.0  # seconds without a sweep after which the compile service is stuck


@dataclass(slots=True)
class Readiness:
    """The checks of a server; their results are kept for some seconds."""

    store: Store
    storage: Storage
    compiling: CompileService
    threads: GatewayThreads
    clock: Callable[[], float] = time.monotonic
    _lock: asyncio.Lock = field(default_factory=asyncio.Lock)
    _checked: float = float("-inf")
    _checks: dict[str, str] = field(default_factory=dict)
    _running: asyncio.Future[dict[str, str]] | None = None

    async def checks(self) -> dict[str, str]:
        """Return "ok" or the fault of each component."""
        async with self._lock:
            if self.clock() - self._checked >= _KEEP:
                # A check that hangs, because the database or a disk does, occupies one of the
                # threads of heartbeats: there is never a second one.
                if self._running is None or self._running.done():
                    self._running = asyncio.ensure_future(self.threads.reports(self._check))
                done, _ = await asyncio.wait((self._running,), timeout=_PATIENCE)
                self._checks = self._running.result() if done else {"database": "no answer"}
                self._checked = self.clock()
            return self._checks | {"workers": self._workers()}

    def _check(self) -> dict[str, str]:
        return {
            "database": self._database(),
            "schema": self._schema(),
            "disk": self.storage.fault(),
        }

    def _database(self) -> str:
        try:
            write_probe(self.store.database)
        except sqlalchemy.exc.SQLAlchemyError as reason:
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
