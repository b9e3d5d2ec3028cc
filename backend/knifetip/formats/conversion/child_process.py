"""child_process: run a program on files of others, with limits of time, memory and disk.

The program runs in a folder of its own, without a shell, without standard input and with few
environment variables.  ``launcher`` sets the limits that the kernel watches; this module watches
the time on the clock and the size of the folder.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from math import ceil
from pathlib import Path
from typing import Final, Literal

from knifetip.formats import cpu_limit
from knifetip.formats.conversion import launcher

#: Name of the file in the folder with what the program printed.
_LOG: Final = "log.txt"
#: Number of last bytes of the log that are returned.
_LOG_BYTES: Final = 1 << 16
#: Time between two looks at the program (s); it grows from the first to the second.
_SHORTEST, _LONGEST = 0.005, 0.05
#: Variables of the environment that the program gets.  Others may change what it permits, such as
#: GS_OPTIONS of Ghostscript.
_KEPT: Final = ("PATH", "LD_LIBRARY_PATH")

#: Limit that a program has exceeded; "" for none.
Exceeded = Literal["", "time", "disk"]


@dataclass(frozen=True, slots=True)
class Budget:
    """Limits of a program."""

    cpu: float  #: processor time (s)
    seconds: float  #: time on the clock (s)
    memory: int  #: address space (bytes)
    file_size: int  #: size of each file (bytes)
    disk: int  #: size of all files in the folder together (bytes)


@dataclass(frozen=True, slots=True)
class FinishedProcess:
    """How a program ended."""

    status: int  #: exit status; negative for the number of the signal that ended it
    exceeded: Exceeded  #: limit for which the program was ended
    log: str  #: end of what it printed
    cpu: float  #: processor time that it used (s)


def run_limited(command: Sequence[str], folder: Path, budget: Budget) -> FinishedProcess:
    """Run a program in a folder until it ends or exceeds a limit, and return how it ended.

    Parameters
    ----------
    command
        Absolute path of the program, and its arguments.
    folder
        Folder in which the program runs and has its temporary files.
    budget
        Limits of the program.
    """
    limits = (ceil(budget.cpu), budget.memory, budget.file_size)
    inherited = {name: os.environ[name] for name in _KEPT if name in os.environ}
    places = dict.fromkeys(("HOME", "TMPDIR", "TEMP", "TMP"), str(folder))
    with (folder / _LOG).open("wb") as log:
        process = subprocess.Popen(
            [sys.executable, "-I", "-S", launcher.__file__, *map(str, limits), *command],
            cwd=folder,
            env={**inherited, **places, "LC_ALL": "C"},
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    exceeded: Exceeded = ""
    try:
        exceeded = _wait(process.pid, folder, budget)
    finally:
        with cpu_limit.pause():
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
    return FinishedProcess(
        process.returncode, exceeded, _end_of_log(folder / _LOG), usage.ru_utime + usage.ru_stime
    )


def _wait(pid: int, folder: Path, budget: Budget) -> Exceeded:
    """Wait until a child process has ended or exceeds a limit; it is not reaped."""
    until = time.monotonic() + budget.seconds
    pause = _SHORTEST
    while os.waitid(os.P_PID, pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None:
        if time.monotonic() > until:
            return "time"
        if _size(folder) > budget.disk:
            return "disk"
        time.sleep(pause)
        pause = min(2.0 * pause, _LONGEST)
    return ""


def _size(folder: Path) -> int:
    """Return the size of all files in a folder (bytes)."""
    size = 0
    with os.scandir(folder) as files:
        for file in files:
            # The program may delete files meanwhile.
            with suppress(FileNotFoundError):
                size += file.stat(follow_symlinks=False).st_size
    return size


def _end_of_log(log: Path) -> str:
    """Return the end of what a program has printed; "" if it has removed the file."""
    try:
        with log.open("rb") as file:
            file.seek(max(0, os.fstat(file.fileno()).st_size - _LOG_BYTES))
            return file.read().decode("utf-8", "replace")
    except OSError:
        return ""
