"""crew: processes for the work that takes a processor, each with a time and a memory limit.

    crew.run(task, *arguments, limit=120.0, watch=...) -> what the task returns

A task is a function ``task(progress, *arguments)``; it runs in a process of its own, so a drawing
that hangs, eats all memory or crashes the interpreter takes down that process and nothing else.
``progress(stage, fraction)`` reaches ``watch`` in the calling thread.
"""

from __future__ import annotations

import contextlib
import logging
import multiprocessing
import os
import resource
import signal
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Any, TypeAlias, TypeVar

from knifetip.errors import DrawingTooLarge, KnifetipError
from knifetip.model.stage import Progress, Stage

#: Called with the last stage and its share; False withdraws the task.
Watch: TypeAlias = Callable[[Stage, float], bool]
T = TypeVar("T")

MEMORY = 6 << 30  #: bytes of address space to a process
_LOOK = 1.0  # seconds between two looks at a task that says nothing
_SPOKEN = 0.1  # seconds between two words of progress

_log = logging.getLogger("knifetip.jobs")


class Withdrawn(Exception):
    """Whoever wanted the work wants it no more."""


class Fault(Exception):
    """A task failed in a way that nobody foresaw; its traceback is in the log."""


@dataclass(slots=True)
class _Hand:
    """One process and the line to it."""

    process: BaseProcess
    line: Connection

    def dismiss(self) -> None:
        self.process.kill()
        self.process.join()
        self.line.close()


class Crew:
    """At most ``size`` processes, started when they are first needed and kept."""

    def __init__(self, size: int = 2, memory: int = MEMORY) -> None:
        self._memory = memory
        self._spawn = multiprocessing.get_context("spawn")
        self._idle: list[_Hand] = []
        self._busy: list[_Hand] = []
        self._places = threading.BoundedSemaphore(size)
        self._lock = threading.Lock()
        self._closed = False

    def run(
        self,
        task: Callable[..., T],
        *arguments: object,
        limit: float,
        watch: Watch = lambda _stage, _fraction: True,
    ) -> T:
        """Return ``task(progress, *arguments)`` of another process; blocks this thread.

        Parameters
        ----------
        limit
            Seconds after which the process is killed.
        watch
            Is told each stage, and the last one again every second; False withdraws the task.

        Raises
        ------
        KnifetipError
            What the task raised.
        DrawingTooLarge
            It took longer than ``limit``, or more memory than it may, or killed its process.
        Withdrawn
            ``watch`` said False, or the crew was closed.
        Fault
            The task raised something that is no ``KnifetipError``.
        """
        with self._places:
            with self._lock:
                if self._closed:
                    raise Withdrawn
                hand = self._idle.pop() if self._idle else self._hire()
                self._busy.append(hand)
            sound = False
            try:
                hand.line.send((task, arguments))
                kind, value = self._heard(hand, time.monotonic() + limit, limit, watch)
                sound = True
            except (EOFError, OSError) as reason:
                if self._closed:
                    raise Withdrawn from reason
                hand.process.join(5.0)
                raise DrawingTooLarge(
                    "The process that worked on it died "
                    f"(exit code {hand.process.exitcode}), as it does when memory runs out.",
                    "Send a smaller drawing, or split this one.",
                ) from reason
            finally:
                with self._lock:
                    self._busy.remove(hand)
                    if sound and not self._closed:
                        self._idle.append(hand)
                if not sound:
                    hand.dismiss()
        if kind == "result":
            result: T = value
            return result
        if isinstance(value, KnifetipError):
            raise value
        _log.error("a task failed:\n%s", value)
        raise Fault(str(value).strip().rsplit("\n", 1)[-1])

    def _heard(self, hand: _Hand, deadline: float, limit: float, watch: Watch) -> tuple[str, Any]:
        stage, fraction = Stage.READ, 0.0
        while True:
            left = deadline - time.monotonic()
            if left <= 0:
                raise DrawingTooLarge(
                    f"Stage {stage} was not finished after {limit:.0f} s.",
                    "Send a smaller drawing, or split this one.",
                )
            if hand.line.poll(min(left, _LOOK)):
                kind, value = hand.line.recv()
                if kind != "progress":
                    return kind, value
                stage, fraction = value
            if not watch(stage, fraction):
                raise Withdrawn

    def _hire(self) -> _Hand:
        ours, theirs = self._spawn.Pipe()
        process = self._spawn.Process(
            target=_work, args=(theirs, self._memory), name="knifetip crew", daemon=True
        )
        process.start()
        theirs.close()
        return _Hand(process, ours)

    def close(self) -> None:
        """End all processes, and with them their tasks."""
        with self._lock:
            self._closed = True
            idle, self._idle = self._idle, []
            busy = list(self._busy)
        for hand in busy:
            hand.process.kill()
        for hand in idle:
            hand.dismiss()


def _work(line: Connection, memory: int) -> None:
    """Live in the process: do what comes down the line until it closes."""
    # Ctrl-C reaches the whole group: it is for the server to decide when its crew goes home.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    allowed = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (allowed, hard))
    threading.Thread(target=_go_with_the_parent, daemon=True).start()
    spoken = 0.0
    said: Stage | None = None

    def progress(stage: Stage, fraction: float) -> None:
        nonlocal spoken, said
        if stage != said or time.monotonic() - spoken > _SPOKEN:
            spoken, said = time.monotonic(), stage
            line.send(("progress", (stage, float(fraction))))

    with contextlib.suppress(EOFError, OSError):
        while True:
            task, arguments = line.recv()
            said = None
            line.send(_answer(task, progress, arguments))


def _answer(task: Callable[..., Any], progress: Progress, arguments: Any) -> tuple[str, Any]:
    try:
        return "result", task(progress, *arguments)
    except KnifetipError as reason:
        return "error", reason
    except MemoryError:
        return "error", DrawingTooLarge(
            f"It needs more than the {MEMORY >> 30} GB that one drawing may take.",
            "Send a smaller drawing, or split this one.",
        )
    except Exception:
        return "error", traceback.format_exc()


def _go_with_the_parent() -> None:
    """End at once when the server is gone, even killed: nobody waits for the result."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(0)
