"""warm_up: compiles the kernels that have no machine code yet, in processes beside the server.

    python -m knifetip.service.processes.warm_up        compiles all kernels and prints the progress

Kernels are the functions that numba compiles.  Two processes compile the kernels, module by module,
in the order of ``kernel_groups.GROUPS``: first the kernels that read drawings, then those that
compile jobs, then those that offset contours.  A request that needs a group of kernels waits until
this group is compiled; other requests are served meanwhile.  The processes end after the last
module, because compiling leaves hundreds of megabytes in them.
"""

from __future__ import annotations

import contextlib
import logging
import os
import sys
import threading
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from knifetip.errors import KnifetipError
from knifetip.messages import Message
from knifetip.model.stage import Stage
from knifetip.service.processes import tasks
from knifetip.service.processes.kernel_groups import GROUPS, Part
from knifetip.service.processes.pool import ProcessPool, TaskCancelled, TaskFailed, Watch

NICENESS = 10  #: of compiling processes beside a server
_AT_ONCE = min(2, os.cpu_count() or 1)  # processes; each compiles again what both need
_LIMIT = 900.0  # seconds that the kernels of one module may take
_WATCH_INTERVAL = 0.5  # seconds between two progress reports to a waiting caller

_log = logging.getLogger("knifetip.jobs")


@dataclass(frozen=True, slots=True)
class WarmUpProgress:
    """Progress of a warm-up: how many kernels it has compiled, and whether it has finished.

    Kernels are functions that numba compiles.
    """

    finished: bool
    compiled: int = 0  #: kernels
    total: int = 0  #: kernels that had no machine code when it began


class WarmUp:
    """Compiles all kernels without machine code once; threads can wait for groups of kernels.

    Parameters
    ----------
    groups
        Names of the groups to compile, from ``kernel_groups.GROUPS``, in order.
    niceness
        Niceness of the compiling processes (see ``nice``).
    on_progress
        Called after each change with the progress, on a thread of the warm-up.
    """

    def __init__(
        self,
        groups: tuple[str, ...] = tuple(GROUPS),
        niceness: int = NICENESS,
        on_progress: Callable[[WarmUpProgress], object] = lambda _progress: None,
    ) -> None:
        self._groups = groups
        self._niceness = niceness
        self._on_progress = on_progress
        self._changed = threading.Condition()
        # A server that was never started is not waited for.
        self._running = False
        self._closed = False
        self._failed = False
        self._parts: list[Part] | None = None  # None until it is known what is missing
        self._waiting: deque[Part] = deque()
        self._fractions: dict[str, float] = {}  # of the kernels of each module that are compiled
        self._compilers: ProcessPool | None = None

    @property
    def progress(self) -> WarmUpProgress:
        """Numbers of kernels to compile in this warm-up, and of kernels compiled so far."""
        with self._changed:
            return self._progress()

    def _progress(self, groups: tuple[str, ...] = ()) -> WarmUpProgress:
        parts = [one for one in self._parts or () if not groups or one.group in groups]
        compiled = sum(int(one.kernels * self._fractions.get(one.module, 0.0)) for one in parts)
        return WarmUpProgress(not self._running, compiled, sum(one.kernels for one in parts))

    def start(self, pool: ProcessPool) -> None:
        """Begin to compile the kernels without machine code, on a thread of the warm-up.

        Parameters
        ----------
        pool
            Pool of worker processes.  One of them finds the kernels that have no machine code.
        """
        self._running = True
        threading.Thread(target=self.run, args=(pool,), name="warm-up", daemon=True).start()

    def run(self, pool: ProcessPool) -> bool:
        """Compile the kernels without machine code, and return when this is done.

        Parameters
        ----------
        pool
            Pool of worker processes.  One of them finds the kernels that have no machine code.

        Returns
        -------
        bool
            False if the kernels of a module could not be compiled, else True.
        """
        self._running = True
        try:
            with contextlib.suppress(TaskCancelled):
                parts = pool.run(tasks.missing_kernels, self._groups, limit=_LIMIT)
                with self._changed:
                    self._parts = parts
                    self._waiting.extend(parts)
                    self._changed.notify_all()
                if parts:
                    self._compile()
        except (KnifetipError, TaskFailed):
            # Each kernel is then compiled where it is first called.
            self._failed = True
            _log.exception("the warm-up failed")
        finally:
            with self._changed:
                self._running = False
                self._changed.notify_all()
            self._on_progress(self.progress)
        return not self._failed

    def _compile(self) -> None:
        compilers = ProcessPool(_AT_ONCE)
        with self._changed:
            self._compilers = compilers
            if self._closed:
                return
        threads = [
            threading.Thread(target=self._compile_parts, args=(compilers,), name="warm-up")
            for _ in range(_AT_ONCE)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        compilers.close()

    def _compile_parts(self, compilers: ProcessPool) -> None:
        while (part := self._next_part()) is not None:
            module = part.module

            def watch(_stage: Stage, fraction: float, module: str = module) -> bool:
                # Only the end of its task makes a module ready.
                self._set_fraction(module, min(fraction, 0.999))
                return not self._closed

            try:
                compilers.run(
                    tasks.compile_kernels, module, self._niceness, limit=_LIMIT, watch=watch
                )
            except TaskCancelled:
                return
            except (KnifetipError, TaskFailed):
                self._failed = True
                _log.exception("the kernels of %s were not compiled", module)
            self._set_fraction(module, 1.0)

    def _next_part(self) -> Part | None:
        with self._changed:
            return self._waiting.popleft() if self._waiting and not self._closed else None

    def _set_fraction(self, module: str, fraction: float) -> None:
        with self._changed:
            if self._fractions.get(module) == fraction:
                return
            self._fractions[module] = fraction
            self._changed.notify_all()
        self._on_progress(self.progress)

    def wait(self, *groups: str, watch: Watch = lambda _stage, _fraction: True) -> None:
        """Wait until the kernels (functions that numba compiles) of the given groups are compiled.

        Parameters
        ----------
        *groups
            Names of the groups, from ``kernel_groups.GROUPS``.
        watch
            Called repeatedly during the wait, with the stage ``PREPARE`` and the fraction of the
            kernels that are compiled.  It returns False to stop the wait.

        Raises
        ------
        TaskCancelled
            ``watch`` returned False, or the warm-up was closed.
        """
        while True:
            with self._changed:
                ready = self._changed.wait_for(
                    lambda: self._is_ready(groups), timeout=_WATCH_INTERVAL
                )
                if self._closed:
                    raise TaskCancelled
                if ready:
                    return
                progress = self._progress(groups)
            if not watch(Stage.PREPARE, progress.compiled / max(progress.total, 1)):
                raise TaskCancelled

    def fraction_compiled(self, *groups: str) -> float:
        """Return the fraction (0 … 1) of the kernels of the given groups that are compiled.

        Kernels are functions that numba compiles.  Only kernels without machine code at the start
        of the warm-up are counted.  The result is 1 if all of them are compiled, or if no warm-up
        is running.

        Parameters
        ----------
        *groups
            Names of the groups, from ``kernel_groups.GROUPS``.
        """
        with self._changed:
            if self._is_ready(groups):
                return 1.0
            progress = self._progress(groups)
        return min(progress.compiled / max(progress.total, 1), 0.999)

    def _is_ready(self, groups: tuple[str, ...]) -> bool:
        if not self._running or self._closed:
            return True
        return self._parts is not None and all(
            self._fractions.get(part.module) == 1.0 for part in self._parts if part.group in groups
        )

    def close(self) -> None:
        """Stop compiling; threads that wait in ``wait`` raise ``TaskCancelled``."""
        with self._changed:
            self._closed = True
            compilers = self._compilers
            self._changed.notify_all()
        if compilers is not None:
            compilers.close()


def main() -> None:
    """Compile all kernels without machine code, with normal priority, and print the progress."""
    shown = -1

    def show(progress: WarmUpProgress) -> None:
        nonlocal shown
        # A line for each twentieth: logs of builds keep them.
        twentieth = 20 * progress.compiled // max(progress.total, 1)
        if progress.total and twentieth != shown:
            shown = twentieth
            done = Message("output.kernels", compiled=progress.compiled, total=progress.total)
            print(done, flush=True)

    pool = ProcessPool(1)
    succeeded = WarmUp(niceness=0, on_progress=show).run(pool)
    pool.close()
    if not succeeded:
        sys.exit("Some kernels were not compiled. See the errors above.")


if __name__ == "__main__":
    main()
