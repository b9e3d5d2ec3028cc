"""Space on the disks of a server: the free space, and the reserve for running jobs (ADR 84)."""

from __future__ import annotations

import shutil
import tempfile
from functools import cached_property
from pathlib import Path
from typing import Final

from starlette.requests import Request
from starlette.types import ASGIApp, Receive, Scope, Send

from knifetip.messages import Message
from knifetip.service.database.url import sqlite_file
from knifetip.service.http.problems import problem

OK: Final = "ok"
_TEMPORARY: Final = 16 << 20  # bytes that must be free for temporary files, if less than the limit
#: Routes that store much; those of gateways and of jobs that are on a machine are never refused.
_STORING: Final = ("/api/drawings", "/api/jobs", "/api/orders")


class Storage:
    """The folders in which a server stores data, and the space that must remain free in them.

    Parameters
    ----------
    url
        URL of the database.
    least
        Bytes that must remain free beside an SQLite database, for the events of running jobs.
    contents
        Folder of the option --store; None if large values are elsewhere.
    """

    def __init__(self, url: str, least: int, contents: Path | None = None) -> None:
        self.least = least
        self._url = url
        self._contents = contents

    @cached_property
    def data(self) -> Path | None:
        """Folder of an SQLite database; None if the database is on a PostgreSQL server."""
        file = sqlite_file(self._url)
        return None if file is None else file.absolute().parent

    @cached_property
    def _least_by_folder(self) -> dict[Path, int]:
        # Uploads are in the folder of temporary files until they are read.
        folders = {Path(tempfile.gettempdir()): min(self.least, _TEMPORARY)}
        if self.data is not None:
            folders[self.data] = self.least
        if self._contents is not None:
            folders[self._contents] = self.least
        return folders

    def shortage(self) -> tuple[int, int] | None:
        """Return the free bytes and the necessary ones of a folder with too few, or None."""
        for folder, least in self._least_by_folder.items():
            free = shutil.disk_usage(folder).free
            if free < least:
                return free, least
        return None

    def fault(self) -> str:
        """Return "ok", or what is wrong with the folders."""
        try:
            if (short := self.shortage()) is not None:
                return f"{short[0] >> 20} MB free, {short[1] >> 20} MB needed"
            for folder in filter(None, (self.data, self._contents)):
                with tempfile.TemporaryFile(dir=folder) as file:
                    file.write(b"knifetip")
                    file.flush()
        except OSError as reason:
            return f"not writable: {reason.strerror}"
        return OK


class DiskSpaceGuard:
    """ASGI middleware that refuses uploads and orders with 507 while too little space is free."""

    def __init__(self, app: ASGIApp, storage: Storage) -> None:
        self.app = app
        self._storage = storage

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Forward a request, or refuse it before its body is read."""
        app = self.app
        if scope["type"] == "http" and _stores_upload(Request(scope)):
            try:
                short = self._storage.shortage()
            except OSError:
                short = None  # the request itself reports the error
            if short is not None:
                message = Message("limit.disk-low", free=short[0] >> 20, least=short[1] >> 20)
                app = problem(507, message, headers={"Connection": "close"})
        await app(scope, receive, send)


def _stores_upload(request: Request) -> bool:
    if request.method != "POST":
        return False
    path = request.url.path
    kind = request.headers.get("content-type", "").lower()
    return path in _STORING or (
        kind.startswith("multipart/form-data") and path.startswith(_STORING)
    )
