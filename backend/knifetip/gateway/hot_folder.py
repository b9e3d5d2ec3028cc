"""hot_folder: a controller that takes programs from a folder, ``file:///FOLDER``.

Each program is written under a temporary name and then renamed, so that the software of the machine
never reads a part of a program.  A person confirms that the program was executed (``open_loop``).

Until then a hidden file in the folder contains the name of the program file.  A gateway that is
started after it was killed deletes that program file, so that a job which is queued again is not in
the folder twice.
"""

from __future__ import annotations

import asyncio
import errno
import os
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any
from urllib.parse import SplitResult, urlsplit
from urllib.request import url2pathname

from knifetip.errors import ControllerError, NoSuchController
from knifetip.gateway.controller import SafeState, Status
from knifetip.gateway.open_loop import OpenLoop
from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine

#: Scheme of the addresses of folders.
SCHEME = "file"


class HotFolder(OpenLoop):
    """A folder from which the machine takes its programs; the methods are those of ``OpenLoop``.

    Parameters
    ----------
    folder
        The folder.
    stem, suffix
        First part and last part of the names of program files, for example ``mine`` and ``.ngc``;
        a number is written between them.
    """

    def __init__(self, folder: Path, stem: str, suffix: str) -> None:
        super().__init__(str(folder))
        self._folder = folder
        self._stem = stem
        self._suffix = suffix
        self._file: Path | None = None
        self._note = folder / f".{stem}-unconfirmed"

    async def open(self) -> None:
        """Delete the program file that a killed gateway left behind, if it is still there.

        Raises
        ------
        ControllerError
            The file cannot be deleted.
        """
        try:
            await asyncio.to_thread(self._delete_unconfirmed)
        except OSError as error:
            raise _unusable(self.name, error) from error

    async def run(self, text: bytes) -> Status:
        """Hand a program over, and return when a person has confirmed that it is executed.

        Raises
        ------
        ControllerError
            The program could not be written.
        """
        status = await super().run(text)
        self._file = None
        self._forget()
        return status

    async def hand_over(self, text: bytes) -> None:
        """Write a program into the folder under a name that is not in use.

        Raises
        ------
        ControllerError
            The program cannot be written.
        """
        try:
            self._file = await asyncio.to_thread(self._write, text)
        except OSError as error:
            raise _unusable(self.name, error) from error
        self.sent += text.count(b"\n")

    async def withdraw(self) -> ControllerError:
        """Delete the program file; return the error that states whether the machine took it."""
        file, self._file = self._file, None
        self._forget()
        if file is None:
            return ControllerError("folder.not-written", folder=self.name)
        try:
            file.unlink()
        except FileNotFoundError:
            return ControllerError("folder.taken", file=str(file))
        except OSError as error:
            return ControllerError("folder.not-deleted", file=str(file), reason=error)
        return ControllerError("folder.deleted", file=str(file))

    def _write(self, text: bytes) -> Path:
        """Write a program file and return its path; the file appears complete or not at all."""
        temporary = self._folder / f".{self._stem}-{os.getpid()}.part"
        try:
            with temporary.open("wb") as file:
                file.write(text)
                file.flush()
                os.fsync(file.fileno())
            number = 1
            while (path := self._folder / f"{self._stem}-{number:04}{self._suffix}").exists():
                number += 1
            # Before the program appears: a gateway that is killed here leaves no unknown file.
            self._note.write_text(path.name, encoding="utf-8")
            temporary.rename(path)
        except OSError:
            temporary.unlink(missing_ok=True)
            raise
        return path

    def _forget(self) -> None:
        """Delete the name of the program file; a name that remains does not fail a finished job."""
        with suppress(OSError):
            self._note.unlink()

    def _delete_unconfirmed(self) -> None:
        try:
            name = self._note.read_text(encoding="utf-8")
        except FileNotFoundError:
            return
        # Other programs may write into the folder too, so the name may be anything.
        if name == Path(name).name and name.startswith(f"{self._stem}-"):
            (self._folder / name).unlink(missing_ok=True)
        self._note.unlink(missing_ok=True)


def find_driver(machine: Machine, address: str) -> Callable[..., Any]:
    """Return the driver for a machine and an address: the hot folder's or that of the language.

    Raises
    ------
    ControllerError
        The language of the machine has no driver, and the address is not a folder.
    """
    language = find_language(machine.dialect)
    if urlsplit(address).scheme == SCHEME:
        return partial(dial, stem=machine.name, suffix=language.suffix)
    driver: Callable[..., Any] = language.load_driver(machine)
    return driver


async def dial(
    address: str,
    safe: SafeState | None = None,
    *,
    stop_motion: bool = False,
    stem: str,
    suffix: str,
) -> HotFolder:
    """Return the folder of a URL as a controller.

    ``safe`` and ``stop_motion`` have no effect, because nothing is sent to the machine.

    Raises
    ------
    ControllerError
        The URL names no folder in which files can be created and deleted.
    """
    del safe, stop_motion
    folder = _folder_of(urlsplit(address))
    try:
        if not folder.is_dir():
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
        if not os.access(folder, os.W_OK | os.X_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    except OSError as error:
        raise _unusable(str(folder), error) from error
    controller = HotFolder(folder, stem, suffix)
    await controller.open()
    return controller


def _folder_of(url: SplitResult) -> Path:
    """Return the folder of ``file:///FOLDER``."""
    if url.netloc not in ("", "localhost") or not url.path.strip("/") or url.query:
        raise NoSuchController("folder.bad-address", address=url.geturl())
    return Path(url2pathname(url.path))


def _unusable(folder: str, error: OSError) -> ControllerError:
    return ControllerError("folder.unusable", folder=folder, reason=error)
