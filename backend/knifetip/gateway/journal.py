"""journal: what this gateway did, line by line, in a file beside the table.

events -> JSON lines, appended and flushed; the last job that has no end, read back after a crash

The server has its own record.  This one survives a server that cannot be reached, and a gateway
that was switched off while the machine was cutting.
"""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

#: A journal longer than this (bytes) is set aside as ``.1`` when the next job begins.
LONG = 8_000_000


class Journal:
    """An append-only file of events; with no path, nothing is kept."""

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._last: tuple[object, ...] = ()

    def begin(self, job: str, epoch: int, sha256: str, lines: int) -> None:
        """A job was claimed; nothing has moved yet."""
        if self._path is not None and self._path.exists() and self._path.stat().st_size > LONG:
            self._path.replace(self._path.with_name(self._path.name + ".1"))
        self._append(
            {"event": "begin", "job": job, "epoch": epoch, "sha256": sha256, "lines": lines},
            safe=True,
        )

    def line(self, job: str, copy: int, executed: int, acknowledged: int) -> None:
        """So far the machine has come."""
        now = (job, copy, executed, acknowledged)
        if now != self._last:
            self._last = now
            self._append(
                {
                    "event": "line",
                    "job": job,
                    "copy": copy,
                    "executed": executed,
                    "acknowledged": acknowledged,
                }
            )

    def end(self, job: str, epoch: int, outcome: str, why: str) -> None:
        """How it ended, as far as this gateway knows."""
        self._append(
            {"event": "end", "job": job, "epoch": epoch, "outcome": outcome, "why": why},
            safe=True,
        )

    def unfinished(self) -> tuple[str, int, int] | None:
        """Return job, epoch and executed lines of a job that has no end, or None."""
        if self._path is None or not self._path.exists():
            return None
        job, epoch, executed, running = "", 0, 0, False
        with self._path.open("rb") as file:
            for raw in file:
                try:
                    row = json.loads(raw)
                    event = row["event"]
                    if event == "begin":
                        job, epoch, executed, running = row["job"], int(row["epoch"]), 0, True
                    elif event == "line" and row["job"] == job:
                        executed = int(row["executed"])
                    elif event == "end" and row["job"] == job:
                        running = False
                except (ValueError, KeyError, TypeError):
                    continue  # the power went in the middle of a line
        return (job, epoch, executed) if running else None

    def _append(self, row: dict[str, object], *, safe: bool = False) -> None:
        if self._path is None:
            return
        with self._path.open("ab") as file:
            file.write(json.dumps({"at": round(time.time(), 3), **row}).encode() + b"\n")
            if safe:
                file.flush()
                os.fsync(file.fileno())
