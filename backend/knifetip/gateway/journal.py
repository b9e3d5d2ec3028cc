"""journal: a file in which the gateway records the progress and the end of each job.

The file has one JSON object per line; it is closed after each line.  The file also contains events
that may not reach the server: progress while the server cannot be reached, and the end of a job if
the gateway is switched off before the server has answered.
"""

from __future__ import annotations

import contextlib
import json
import logging
import os
import re
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from knifetip.messages import Message, from_json

#: A longer journal (bytes) is renamed to ``.1`` when the next job starts.
LONG = 8_000_000
#: Size of the record of the sent lines (bytes), so that it is always overwritten completely.
_SENT_SIZE = 512
#: Events that precede motion for which the gateway is responsible.
_MOTION = ("begin", "dry-run")

_log = logging.getLogger(__name__)


@dataclass(slots=True)
class UnfinishedJob:
    """A job in the journal whose end is not recorded as acknowledged by the server.

    It may still run, or it has ended and the server has not answered the report of its end.
    """

    job: str
    epoch: int
    sha256: str = ""  #: checksum of its program
    lines: int = 0
    copies: int = 1
    copies_done: int = 0  #: executed to their last line
    line: int = 0  #: executed lines of the copy that was under way
    line_at_most: int | None = None  #: lines that may have been executed; None if not known
    copy_begun: bool = True  #: a line of the copy that is under way may have been sent
    #: most lines of this copy that were sent, by a controller that takes them one by one; None if
    #: not known
    sent_at_most: int | None = None
    program: str = ""  #: name by which the controller knows the program of this copy
    outcome: str = ""  #: how it ended; empty if it did not end
    cause: Message | None = None  #: cause of the end; None if none was recorded


def default_path(machine: str, server: str) -> Path:
    """Return the path of the journal of a gateway for which no path is given.

    It lies in ``$XDG_STATE_HOME/knifetip``, by default ``~/.local/state/knifetip``, and has a name
    of its own for each machine and server.

    Parameters
    ----------
    machine
        Name of the machine.
    server
        Address of the server or of its database, without a password.
    """
    state = os.environ.get("XDG_STATE_HOME")
    folder = Path(state) if state else Path.home() / ".local" / "state"
    name = re.sub(r"[^A-Za-z0-9._-]+", "-", f"{machine} {server}").strip("-.")[-120:]
    return folder / "knifetip" / f"{name}.gateway.jsonl"


class Journal:
    """A file to which events of jobs are appended; if its path is None, nothing is stored.

    ``begin``, ``begin_copy`` of the first copy, ``dry_run`` and ``rest`` raise ``OSError`` if the
    file cannot be written, so that the machine does not begin.  The other events are omitted with a
    warning then: a cut must not be interrupted because a disk is full, and the end of a job must
    still be reported to the server.
    """

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._complaint = ""  # the last logged failure to write an event
        self._last: tuple[object, ...] = ()
        self._abandoned: bool | None = None  # None: not read yet
        self._epoch = 0  # of the job that runs
        self._sent = None if path is None else path.with_name(path.name + ".sent")
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            if path.exists():
                _end_last_line(path)

    def begin(self, job: str, epoch: int, sha256: str, lines: int, copies: int = 1) -> None:
        """Record that a job starts, before the check run of its program.

        Parameters
        ----------
        job
            Id of the job.
        epoch
            Epoch of the claim: a number that the server increases whenever the job gets a new
            owner.
        sha256
            Checksum of the program.
        lines
            Number of lines of the program.
        copies
            Number of copies to make.
        """
        self._abandoned = True
        self._epoch = epoch
        if self._path is not None and self._path.exists() and self._path.stat().st_size > LONG:
            self._path.replace(self._path.with_name(self._path.name + ".1"))
        self._append(
            {
                "event": "begin",
                "job": job,
                "epoch": epoch,
                "sha256": sha256,
                "lines": lines,
                "copies": copies,
                # Earlier versions recorded the begin of the first copy before its check run.
                "copy_begun": False,
            },
            safe=True,
        )

    def dry_run(self, job: str) -> None:
        """Record that the machine begins a run above the board, for a job that waits."""
        self._abandoned = True
        self._append({"event": "dry-run", "job": job}, safe=True)

    def line(self, job: str, copy: int, executed: int, acknowledged: int) -> None:
        """Record the progress of the machine, if it has changed since the last call.

        Parameters
        ----------
        job
            Id of the job.
        copy
            Number of the running copy, from 0.
        executed
            Number of program lines that the machine has executed.
        acknowledged
            Number of program lines that the controller has answered.
        """
        now = (job, copy, executed, acknowledged)
        if now != self._last:
            self._last = now
            self._append_if_possible(
                {
                    "event": "line",
                    "job": job,
                    "copy": copy,
                    "executed": executed,
                    "acknowledged": acknowledged,
                }
            )

    def record_sending(self, job: str, copy: int, line: int) -> None:
        """Record that lines of a copy are sent from now on, up to a line.

        A file of its own is overwritten, which needs no room on the disk.  If that fails, it is
        removed: a bound that is too low would be taken for the truth.

        Parameters
        ----------
        job
            Id of the job.
        copy
            Number of the running copy, from 0.
        line
            Last line that may be sent.
        """
        if self._sent is None:
            return
        row = {"job": job, "epoch": self._epoch, "copy": copy, "line": line}
        try:
            with self._sent.open("r+b" if self._sent.exists() else "w+b") as file:
                file.write(json.dumps(row).encode().ljust(_SENT_SIZE) + b"\n")
                file.flush()
                os.fsync(file.fileno())
        except OSError as error:
            _log.warning("the sent lines cannot be recorded: %s", error)
            with contextlib.suppress(OSError):
                self._sent.unlink(missing_ok=True)

    def _sent_at_most(self, left: UnfinishedJob) -> int | None:
        """Return the last line of the present copy that may have been sent; None if not known."""
        if self._sent is None:
            return None
        try:
            row = json.loads(self._sent.read_bytes())
            if (row["job"], row["epoch"], row["copy"]) != (left.job, left.epoch, left.copies_done):
                return None
            return max(left.line, min(int(row["line"]), left.lines))
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def begin_copy(self, job: str, copy: int = 0) -> None:
        """Record that a copy begins, after the check run and before any line of it is sent.

        Parameters
        ----------
        job
            Id of the job.
        copy
            Number of the copy, from 0.

        Raises
        ------
        OSError
            The begin of the first copy cannot be written: after a kill -9, the job would be taken
            for one of which nothing was executed.
        """
        row: dict[str, object] = {"event": "copy-begin", "job": job}
        if copy == 0:
            self._append(row, safe=True)
        else:
            self._append_if_possible(row, safe=True)

    def program(self, job: str, name: str) -> None:
        """Record the name by which the controller knows the program that it executes now."""
        self._append_if_possible({"event": "program", "job": job, "name": name})

    def record_copy(self, job: str, copies_done: int) -> None:
        """Record that a copy was executed to its last line and the machine is at rest.

        Parameters
        ----------
        job
            Id of the job.
        copies_done
            Number of copies executed so far.
        """
        self._append_if_possible(
            {"event": "copy", "job": job, "copies_done": copies_done}, safe=True
        )

    def record_outcome(
        self, job: str, outcome: str, cause: Message | None, line_at_most: int | None = None
    ) -> None:
        """Record how a job ended, before it is reported to the server.

        Parameters
        ----------
        job
            Id of the job.
        outcome
            ``done``, ``interrupted``, ``cancelled`` or ``returned``.
        cause
            Cause of the end; None if there is none.
        line_at_most
            Most lines of the last copy that may have been executed; None if not known.
        """
        row: dict[str, object] = {
            "event": "outcome",
            "job": job,
            "outcome": outcome,
            "why": _plain(cause),
            "line_at_most": line_at_most,
        }
        self._append_if_possible(row, safe=True)

    def end(self, job: str, epoch: int, outcome: str, cause: Message | None) -> None:
        """Record that the server has answered the report of the end of a job.

        Parameters
        ----------
        job
            Id of the job.
        epoch
            Epoch of the claim: a number that the server increases whenever the job gets a new
            owner.
        outcome
            ``done``, ``interrupted``, ``cancelled`` or ``returned``.
        cause
            Cause of the end; None if there is none.
        """
        self._append_if_possible(
            {
                "event": "end",
                "job": job,
                "epoch": epoch,
                "outcome": outcome,
                "why": _plain(cause),
            },
            safe=True,
        )

    def rest(self) -> None:
        """Record that the controller is idle and executes no lines of a job or a dry run."""
        if self.is_abandoned():
            self._append({"event": "rest"}, safe=True)
        self._abandoned = False

    def is_abandoned(self) -> bool:
        """Return whether the controller was not seen idle since a job or a dry run began.

        It may still execute lines of it or be held in one, even if the end of the job was reported
        to the server.
        """
        if self._abandoned is None:
            self._abandoned = False
            for row in self._rows():
                self._abandoned = row["event"] in _MOTION or (
                    self._abandoned and row["event"] != "rest"
                )
        return self._abandoned

    def unfinished(self) -> UnfinishedJob | None:
        """Return the last job of the journal if the server has not acknowledged its end.

        Returns None if the server has acknowledged the end of this job, or if the journal contains
        no job.
        """
        unfinished: UnfinishedJob | None = None
        for row in self._rows():
            # An event with missing or wrong fields is skipped.
            with contextlib.suppress(ValueError, KeyError, TypeError):
                unfinished = _apply(unfinished, row)
        if unfinished is not None:
            unfinished.sent_at_most = self._sent_at_most(unfinished)
        return unfinished

    def _rows(self) -> Iterator[dict[str, Any]]:
        """Yield the events of the journal; incomplete ones are skipped."""
        if self._path is None or not self._path.exists():
            return
        with self._path.open("rb") as file:
            for raw in file:
                try:
                    row = json.loads(raw)
                except ValueError:
                    continue  # the line is incomplete after a power failure
                if isinstance(row, dict) and "event" in row:
                    yield row

    def _append_if_possible(self, row: dict[str, object], *, safe: bool = False) -> None:
        """Append an event, or log a warning if the file cannot be written."""
        try:
            self._append(row, safe=safe)
        except OSError as error:
            if (complaint := str(error)) != self._complaint:
                self._complaint = complaint
                _log.warning("the journal cannot be written: %s", complaint)
        else:
            self._complaint = ""

    def _append(self, row: dict[str, object], *, safe: bool = False) -> None:
        if self._path is None:
            return
        with self._path.open("ab") as file:
            file.write(json.dumps({"at": round(time.time(), 3), **row}).encode() + b"\n")
            if safe:
                file.flush()
                os.fsync(file.fileno())


def _plain(cause: Message | None) -> dict[str, Any] | None:
    return None if cause is None else cause.as_json()


def _end_last_line(path: Path) -> None:
    """Append a newline to a file whose last line has none, so that the next event can be read."""
    with path.open("r+b") as file:
        if file.seek(0, os.SEEK_END) and file.seek(-1, os.SEEK_END) >= 0 and file.read(1) != b"\n":
            file.write(b"\n")


def _apply(unfinished: UnfinishedJob | None, row: dict[str, Any]) -> UnfinishedJob | None:
    """Process one event of the journal, and return the job that is unfinished after the event.

    Returns None if no job is unfinished after the event.

    ``unfinished``: job that was unfinished before the event; None if there was none.  It may be
    changed in place.
    """
    event = row["event"]
    if event == "begin":
        return UnfinishedJob(
            row["job"],
            int(row["epoch"]),
            str(row.get("sha256", "")),
            int(row["lines"]),
            int(row.get("copies", 1)),
            copy_begun=bool(row.get("copy_begun", True)),
        )
    if unfinished is None or row["job"] != unfinished.job:
        return unfinished
    if event == "line":
        unfinished.line = int(row["executed"])
        # Also if its begin could not be recorded.
        unfinished.copy_begun = unfinished.copy_begun or unfinished.line > 0
    elif event == "copy":
        unfinished.copies_done, unfinished.line = int(row["copies_done"]), 0
        unfinished.program, unfinished.copy_begun = "", False
    elif event == "copy-begin":
        unfinished.copy_begun = True
    elif event == "program":
        unfinished.program, unfinished.line = str(row["name"]), 0
    elif event == "outcome":
        # Earlier versions recorded a text.
        unfinished.outcome = str(row["outcome"])
        unfinished.cause = from_json(row["why"]) if row["why"] else None
        at_most = row.get("line_at_most")
        unfinished.line_at_most = None if at_most is None else int(at_most)
    elif event == "end":
        return None
    return unfinished
