"""machine_reservation: reserves the machine of an embedded gateway for one server.

Two embedded gateways of one machine would each simulate it, and take jobs from each other.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from knifetip.errors import StoreError

if sys.platform != "win32":
    import fcntl


@contextmanager
def reserved_machine(journal: Path, machine: str, port: int) -> Iterator[None]:
    """Return a context in which no other server can reserve a machine.

    The reservation ends with the process, also if it is killed.  Nothing is reserved where the
    system has no locks.

    Parameters
    ----------
    journal
        Journal of the embedded gateway, which is beside the database; the lock is beside it.
    machine
        Name of the machine.
    port
        Port of this server, which the error of another one contains.

    Raises
    ------
    StoreError
        Another server has reserved the machine, or the file cannot be written.
    """
    file = journal.with_name(journal.name + ".lock")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT, 0o600)
    except OSError as reason:
        raise StoreError(
            "database.folder-unusable", folder=file.parent, reason=reason.strerror
        ) from reason
    try:
        _lock(descriptor, machine)
        os.ftruncate(descriptor, 0)
        os.lseek(descriptor, 0, os.SEEK_SET)
        os.write(descriptor, f"port {port}, process {os.getpid()}".encode())
        yield
    finally:
        os.close(descriptor)


def _lock(descriptor: int, machine: str) -> None:
    if sys.platform != "win32":
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except (BlockingIOError, PermissionError) as reason:
            holder = os.read(descriptor, 200).decode("ascii", "replace") or "unknown"
            raise StoreError("server.machine-taken", holder=holder, machine=machine) from reason
        except OSError:  # a share without locks
            return
