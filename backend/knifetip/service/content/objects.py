"""A folder or a bucket of an object store in which contents are kept outside the database."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol
from urllib.parse import unquote, urlsplit

from knifetip.errors import StoreError
from knifetip.service.database.disk_sync import sync

if TYPE_CHECKING:
    from obstore.store import ObjectStore

_TIMES: Any = {"connect_timeout": "5s", "timeout": "60s"}
_RETRIES: Any = {"max_retries": 3}


class Objects(Protocol):
    """Immutable objects by their names; safe to use from several threads and processes."""

    def put(self, name: str, data: bytes) -> None:
        """Store an object, or replace it; it is on the disk when this method returns."""

    def get(self, name: str) -> bytes | None:
        """Return an object; None if there is none."""

    def delete(self, name: str) -> None:
        """Delete an object, if there is one."""


def open_objects(url: str) -> Objects | None:
    """Return the object store with a URL; None if the URL is empty.

    Parameters
    ----------
    url
        ``file:///FOLDER`` or ``s3://BUCKET/PREFIX``.  The keys and the address of S3 are those of
        the environment (``AWS_ACCESS_KEY_ID``, ``AWS_ENDPOINT_URL`` and others).

    Raises
    ------
    StoreError
        The URL has another form, the folder cannot be created, or the package ``obstore`` is not
        installed.
    """
    if not url:
        return None
    folder = folder_of(url)
    if folder is None and not _names_bucket(url):
        raise StoreError("content.bad-url", url=url)
    try:
        from obstore.store import LocalStore, S3Store  # not installed by default
    except ImportError as reason:
        raise StoreError("content.no-obstore", url=url) from reason
    try:
        if folder is not None:
            return _ObstoreObjects(LocalStore(folder, mkdir=True), url, folder)
        # A store in the local network may have no certificate; its address is then one of HTTP.
        plain = os.environ.get("AWS_ENDPOINT_URL", "").startswith("http://")
        options: Any = {**_TIMES, "allow_http": plain}
        store = S3Store.from_url(url, client_options=options, retry_config=_RETRIES)
    except Exception as reason:  # its classes of errors have no common base
        raise _unavailable(url, reason) from reason
    return _ObstoreObjects(store, url)


def folder_of(url: str) -> Path | None:
    """Return the folder of ``file:///FOLDER``; None for another URL."""
    parts = urlsplit(url)
    if parts.scheme != "file" or parts.netloc or not parts.path.strip("/"):
        return None
    return Path(unquote(parts.path))


class _ObstoreObjects:
    """Objects in a store of ``obstore``."""

    def __init__(self, store: ObjectStore, url: str, folder: Path | None = None) -> None:
        self._store = store
        self._url = url
        self._folder = folder  #: in which the store has its files; None if it has none

    def put(self, name: str, data: bytes) -> None:
        import obstore

        path = _path(name)
        try:
            obstore.put(self._store, path, data)
            if self._folder is not None:
                # obstore does not wait for the disk, but the database does.
                sync(self._folder / path)
                sync((self._folder / path).parent)
        except Exception as reason:
            raise _unavailable(self._url, reason) from reason

    def get(self, name: str) -> bytes | None:
        import obstore

        try:
            return obstore.get(self._store, _path(name)).bytes().to_bytes()
        except FileNotFoundError:
            return None
        except Exception as reason:
            raise _unavailable(self._url, reason) from reason

    def delete(self, name: str) -> None:
        import obstore

        try:
            with suppress(FileNotFoundError):
                obstore.delete(self._store, _path(name))
        except Exception as reason:
            raise _unavailable(self._url, reason) from reason


def _names_bucket(url: str) -> bool:
    parts = urlsplit(url)
    # A key in the URL would be in the list of processes.
    return parts.scheme == "s3" and parts.netloc != "" and "@" not in parts.netloc


def _path(name: str) -> str:
    # Folders with a million files are slow in many file systems.
    return f"{name[:2]}/{name}"


def _unavailable(url: str, reason: Exception) -> StoreError:
    # The further lines are Rust's description of its data.
    line = next(iter(str(reason).splitlines()), type(reason).__name__)
    return StoreError("content.unavailable", url=url, reason=line)
