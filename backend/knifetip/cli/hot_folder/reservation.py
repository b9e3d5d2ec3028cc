"""Reserves a hot folder for one process, so that a second one does not do its work again."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from knifetip.cli.hot_folder.orders import WORKING
from knifetip.errors import SettingsError

if sys.platform != "win32":
    import fcntl

_LOCK = ".lock"  # in ``working``; hidden files are no drawings


@contextmanager
def reserved(folder: Path) -> Iterator[None]:
    """Return a context in which no other process can reserve a hot folder.

    The reservation ends with the process, also if it is killed.  Nothing is reserved where the
    system or the network share has no locks.

    Raises
    ------
    SettingsError
        Another process has reserved the folder.
    OSError
        The folder cannot be used.
    """
    descriptor = os.open(folder / WORKING / _LOCK, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        _lock(descriptor, folder)
        yield
    finally:
        os.close(descriptor)


def _lock(descriptor: int, folder: Path) -> None:
    if sys.platform != "win32":
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except (BlockingIOError, PermissionError) as reason:
            raise SettingsError("watch.taken", folder=str(folder)) from reason
        except OSError:  # a share without locks
            return
