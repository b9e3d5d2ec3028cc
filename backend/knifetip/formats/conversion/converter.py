"""converter: the record of a program that converts files of one format into another.

Such a program is optional and not part of knifetip.  It is found on the PATH, or at the place that
an environment variable names.  It runs as a process of its own, with the limits of a reading.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Final, NamedTuple

from knifetip.errors import DrawingTooLarge, NotADrawing, ReadError
from knifetip.formats import cpu_limit
from knifetip.formats.conversion.child_process import Budget, FinishedProcess, run_limited
from knifetip.formats.limits import Limits
from knifetip.messages import Argument, Message, printable

#: Value of the environment variable of a program that is not to be used.
OFF: Final = "off"
#: Memory of a conversion (bytes).
_MEMORY: Final = 10**9
#: All files of a conversion together may have this many times the size of the largest file.
_FILES: Final = 4
#: Time after which a program that prints its version is given up (s).
_VERSION_SECONDS: Final = 10.0
#: Number of different losses that are stated.
_MOST_LOSSES: Final = 3
_VERSION: Final = re.compile(r"\d+(?:\.\d+)+")


class Program(NamedTuple):
    """A program that converts files, with its path on this computer."""

    path: str  #: absolute path
    version: str  #: such as "10.00.0"; "" if the program does not state it


@dataclass(frozen=True, slots=True)
class Conversion:
    """The result of a conversion."""

    data: bytes  #: the converted file
    kind: Message  #: name of the kind of the file, with a hint what to export instead
    program: str  #: title of the program
    version: str  #: its version, "" if it is unknown
    losses: Sequence[str] = ()  #: what the program could not convert, as it printed it

    @property
    def notes(self) -> list[Message]:
        """Notes for the import report: the program, and what it could not convert."""
        used = f"{self.program} {self.version}".strip()
        notes = [Message("import.converted", program=used)]
        if self.losses:
            notes.append(
                Message(
                    "import.conversion-doubtful",
                    program=self.program,
                    count=len(self.losses),
                    losses=list(dict.fromkeys(map(printable, self.losses)))[:_MOST_LOSSES],
                    what=self.kind,
                )
            )
        return notes

    def refusal_of_result(self, error: ReadError) -> ReadError:
        """Return the error of the reader of the converted file, with what to export instead."""
        return type(error)(
            "conversion.result-unreadable",
            program=self.program,
            what=self.kind,
            error=error.message,
        )

    def empty_file_error(self) -> NotADrawing:
        """Return the error that the converted file contains nothing."""
        return NotADrawing("conversion.no-result", program=self.program, what=self.kind)


class Fault(NamedTuple):
    """The error with which a program ended, as it states it."""

    reason: str  #: "" if it states none
    position: int | None = None  #: position in the file (bytes), None if it is unknown
    is_memory: bool = False  #: whether the program had not enough memory


@dataclass(frozen=True, slots=True)
class Converter:
    """A program that converts files: how it is found, what it reads and writes, how it is run."""

    title: str  #: name in messages, the same in all languages
    program: str  #: name of its command
    variable: str  #: environment variable with the path of the program, or OFF
    least: tuple[int, ...]  #: oldest version that is used; () for every version
    source: str  #: name of the file that it reads
    result: str  #: name of the file that it writes
    yields: str  #: name of the import format of the result
    arguments: tuple[str, ...]  #: arguments of its command
    #: returns the files that the program reads, by name, from the content of a file
    prepare: Callable[[bytes], dict[str, bytes]]
    explain: Callable[[str, bytes], Fault]  #: error in what the program printed, and the file
    #: returns what the program could not convert although it ended well, from what it printed
    list_losses: Callable[[str], Sequence[str]]

    def find(self) -> Program | None:
        """Return the installed program; None if there is none, or an older one than ``least``."""
        named = os.environ.get(self.variable, "").strip()
        if named == OFF:
            return None
        found = shutil.which(named or self.program)
        if found is None:
            return None
        path = str(Path(found).resolve())
        version = _version_of(path, os.stat(path).st_mtime_ns)
        known = tuple(int(part) for part in version.split(".") if part)
        return Program(path, version) if known >= self.least else None

    def convert(
        self, data: bytes, kind: Message, others: Sequence[str], limits: Limits
    ) -> Conversion:
        """Convert a file, within the limits of a reading.

        Parameters
        ----------
        data
            Content of the file.
        kind
            Name of the kind of the file, with a hint what to export instead.
        others
            Titles of the formats that are read without a program.
        limits
            Limits of the size of the file and of the result, and of the time of the conversion.

        Raises
        ------
        NotADrawing
            The program is not installed, or reports an error.
        DrawingTooLarge
            The file or the result is too large, or the program exceeds its limits.
        """
        limits.admit(len(data))
        program = self.find()
        if program is None:
            raise NotADrawing(
                "conversion.no-program",
                what=kind,
                program=self.title,
                command=self.program,
                formats=others,
            )
        left = cpu_limit.remaining()
        budget = Budget(left, limits.seconds, _MEMORY, limits.bytes, _FILES * limits.bytes)
        with _temporary_folder() as folder:
            for file, content in self.prepare(data).items():
                (folder / file).write_bytes(content)
            finished = run_limited([program.path, *self.arguments], folder, budget)
            self._check(finished, data, kind, budget)
            result = folder / self.result
            converted = result.read_bytes() if result.is_file() else b""
        cpu_limit.charge(finished.cpu)
        conversion = Conversion(
            converted, kind, self.title, program.version, self.list_losses(finished.log)
        )
        if not converted:
            raise conversion.empty_file_error()
        return conversion

    def _check(self, finished: FinishedProcess, data: bytes, kind: Message, budget: Budget) -> None:
        """Raise an error if the program has exceeded a limit or stopped with an error."""
        names: dict[str, Argument] = {"what": kind, "program": self.title}
        fault = self.explain(finished.log, data)
        if exceeded := _exceeded_limit(finished, fault, budget):
            code, limits = exceeded
            raise DrawingTooLarge(Message(code, **names, **limits))
        if finished.status == 0:
            return
        status = finished.status
        default = str(status) if status > 0 else signal.Signals(-status).name
        names["reason"] = printable(fault.reason) or default
        if fault.position is None:
            raise NotADrawing(Message("conversion.failed", **names))
        raise NotADrawing(Message("conversion.failed-at", **names, position=fault.position))


@contextmanager
def _temporary_folder() -> Iterator[Path]:
    """Return a new folder that exists in the body of the ``with`` statement."""
    folder = Path(tempfile.mkdtemp(prefix="knifetip-"))
    try:
        yield folder
    finally:
        with cpu_limit.pause():
            shutil.rmtree(folder, ignore_errors=True)


def _exceeded_limit(
    finished: FinishedProcess, fault: Fault, budget: Budget
) -> tuple[str, dict[str, float]] | None:
    """Return the code and arguments of the limit that a program has exceeded; None for none."""
    ended_by = -finished.status
    if finished.exceeded == "time":
        return "conversion.too-slow", {"seconds": budget.seconds}
    if finished.exceeded == "disk" or ended_by == signal.SIGXFSZ:
        return "conversion.too-large", {"limit": budget.file_size / 2**20}
    # SIGKILL follows if the program ignores SIGXCPU.
    if ended_by in (signal.SIGXCPU, signal.SIGKILL):
        return "conversion.too-slow", {"seconds": cpu_limit.READING}
    if finished.status != 0 and fault.is_memory:
        return "conversion.too-much-memory", {"limit": budget.memory / 2**20}
    return None


@lru_cache(maxsize=8)
def _version_of(path: str, _changed: int) -> str:
    """Return the version that a program prints, such as "10.00.0"; "" if it prints none.

    ``_changed`` is the time at which the program was installed.
    """
    with suppress(OSError, subprocess.SubprocessError):
        printed = subprocess.run(
            [path, "--version"],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=_VERSION_SECONDS,
            check=False,
        ).stdout
        if match := _VERSION.search(printed.decode("utf-8", "replace")):
            return match[0]
    return ""
