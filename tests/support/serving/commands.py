"""Run the commands of knifetip in processes of their own, as users start them."""

from __future__ import annotations

import re
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager


class RunningCommand:
    """A ``knifetip`` command in a process, with the lines that it prints on stderr."""

    def __init__(self, *words: object) -> None:
        self.lines: list[str] = []
        self.process = subprocess.Popen(
            [sys.executable, "-m", "knifetip.cli", *map(str, words)],
            stderr=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            text=True,
        )
        self._reader = threading.Thread(target=self._read)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stderr is not None
        self.lines += iter(self.process.stderr.readline, "")

    def said(self, pattern: str) -> str:
        """Wait for a line that contains a pattern, and return the match."""
        deadline = time.monotonic() + 120.0
        while time.monotonic() < deadline:
            for line in list(self.lines):
                if found := re.search(pattern, line):
                    return found[0]
            if self.process.poll() is not None and not self._reader.is_alive():
                break
            time.sleep(0.02)
        raise AssertionError(f"{pattern!r} is not in {self.lines}")

    def stop(self) -> None:
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait(60.0)
        self._reader.join()
        assert self.process.stderr is not None
        self.process.stderr.close()


@contextmanager
def running(*words: object) -> Iterator[RunningCommand]:
    command = RunningCommand(*words)
    try:
        yield command
    finally:
        command.stop()


@contextmanager
def served(database: str, *words: object) -> Iterator[tuple[RunningCommand, str]]:
    """Run a server and yield it with its URL on this computer."""
    parts = ("--no-compiles", "--no-simulator", "--no-samples", "--port", 0)
    with running("serve", "--database", database, *parts, *words) as server:
        port = server.said(r"knifetip is at http://\S+").rpartition(":")[2]
        yield server, f"http://127.0.0.1:{port}"
