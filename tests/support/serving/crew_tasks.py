"""Tasks for worker processes, which cannot import functions of a test module."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from knifetip.errors import CurvedGroove
from knifetip.model.stage import Progress, Stage
from knifetip.service.processes import tasks
from knifetip.service.processes.kernel_groups import Part
from knifetip.service.processes.readings import Reading


def double(progress: Progress, number: int) -> int:
    progress(Stage.PLAN, 0.5)
    return 2 * number


def process_id(progress: Progress) -> int:
    return os.getpid()


def nothing_missing(progress: Progress, groups: Sequence[str]) -> list[Part]:
    return []


def slow_process_id(progress: Progress) -> int:
    time.sleep(1.0)
    return os.getpid()


def refuse(progress: Progress, *_: object) -> NoReturn:
    raise CurvedGroove("groove.curved", count=1, edge=7, source=["2F4"], at_edges=[7, 8])


def fail(progress: Progress, *_: object) -> NoReturn:
    raise ZeroDivisionError("one by none")


def hang(progress: Progress, note: str = "") -> None:
    progress(Stage.PLAN, 0.25)
    if note:
        Path(note).write_text(str(os.getpid()))
    time.sleep(60.0)


def wait_for(progress: Progress, gate: str) -> int:
    """Wait until the file ``gate`` exists, and return the number of the process."""
    progress(Stage.PLAN, 0.25)
    while not Path(gate).exists():
        time.sleep(0.01)
    return os.getpid()


@dataclass(frozen=True)
class GatedReading:
    """The task ``tasks.read``, which begins when the file ``gate`` exists."""

    gate: str
    begun: str  #: file that gets a line for each call

    __name__ = "read"

    def __call__(self, progress: Progress, *arguments: Any) -> Reading:
        with Path(self.begun).open("a") as file:
            file.write(f"{os.getpid()}\n")
        wait_for(progress, self.gate)
        return tasks.read(progress, *arguments)


@dataclass(frozen=True)
class GatedPreparation:
    """Preparation of a worker process that lasts until the file ``gate`` exists."""

    gate: str

    def __call__(self) -> None:
        while not Path(self.gate).exists():
            time.sleep(0.01)


def hang_in_verify(progress: Progress, *_: object) -> None:
    progress(Stage.VERIFY, 0.7)
    time.sleep(60.0)


def eat(progress: Progress, gigabytes: int) -> int:
    return len(np.ones(gigabytes << 27))


def die(progress: Progress, *_: object) -> NoReturn:
    os._exit(3)


def fail_to_start() -> NoReturn:
    os._exit(4)
