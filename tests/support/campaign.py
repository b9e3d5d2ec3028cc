"""Campaigns of random tests that run until they are interrupted, and keep what failed."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path


@contextmanager
def until_interrupted() -> Iterator[None]:
    """Return a context that SIGINT and SIGTERM leave without an error."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    with suppress(KeyboardInterrupt):
        yield


def keep_file(folder: Path | None, name: str, data: bytes) -> None:
    """Write a file to a folder, which is created if necessary; None for no folder."""
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
