"""Packages of XJDF: a document and the files to which it refers, as ZIP or as MIME.

Nothing is written to a disk, and only the files to which a document refers are decompressed.
"""

from __future__ import annotations

import zipfile
import zlib
from email import policy
from email.errors import MessageError
from email.message import EmailMessage, MIMEPart
from email.parser import BytesParser
from io import BytesIO
from pathlib import PurePosixPath
from typing import Final, Protocol
from urllib.parse import unquote, urlsplit

from knifetip.errors import RequestError
from knifetip.service.xjdf.xml import LARGEST

#: Media types of packages, besides multipart/related.
ZIP_TYPES: Final = (
    *("application/vnd.cip4-xjdf+zip", "application/vnd.cip4-xjmf+zip", "application/zip"),
)
MIME: Final = "multipart/related"
#: Name of the XJMF document in a ZIP package.
ROOT_XJMF: Final = "root.xjmf"

_MOST_FILES = 200  # files of a package
_ZIP_START = b"PK\x03\x04"
_ZIP_ENTRY = b"PK\x01\x02"  # begins each entry of the directory
_MOST_ENTRIES = 10_000  # entries of a directory that is read: each one takes memory
#: Methods of compression that XJDF permits.  The others may need much memory, too.
_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_DAMAGED: Final = "it is no ZIP file, or it is damaged or encrypted"
_ZIP_FAULTS = (
    *(zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError),
    *(RuntimeError, NotImplementedError, LookupError),
)
#: Python's email library raises these for malformed heads, and for parts in parts in parts.
_MIME_FAULTS = (
    *(MessageError, RecursionError, ValueError, LookupError, TypeError, AttributeError),
)


class XjdfPackage(Protocol):
    """A document and the files to which it refers by URL."""

    root: bytes  #: the XJDF or XJMF document

    def file(self, url: str) -> bytes:
        """Return a file of the package.

        Raises
        ------
        RequestError
            The package has no such file, or it is too large or damaged.
        """
        ...


class SingleDocument:
    """A document that was sent alone.

    Parameters
    ----------
    root
        The document.
    """

    def __init__(self, root: bytes) -> None:
        self.root = root

    def file(self, url: str) -> bytes:
        """Raise ``RequestError``: there are no other files."""
        raise RequestError("xjdf.no-file", url=url[:200])


class ZipPackage:
    """A package as ZIP.

    Parameters
    ----------
    content
        The package.
    limit
        Largest size of a decompressed file (bytes).
    kind
        Document that the package contains: XJDF or XJMF.

    Raises
    ------
    RequestError
        The package is damaged or encrypted, has names outside of itself, or not one document.
    """

    def __init__(self, content: bytes, limit: int, kind: str) -> None:
        self._limit = limit
        if content.count(_ZIP_ENTRY) > _MOST_ENTRIES:
            raise RequestError("xjdf.many-files", limit=_MOST_FILES)
        try:
            self._zip = zipfile.ZipFile(BytesIO(content))
        except _ZIP_FAULTS as reason:
            raise RequestError("xjdf.bad-package", reason=_DAMAGED) from reason
        # Not ``is_dir``, which fails for an empty name.
        entries = [one for one in self._zip.infolist() if not one.filename.endswith("/")]
        if len(entries) > _MOST_FILES:
            raise RequestError("xjdf.many-files", limit=_MOST_FILES)
        self._entries = {_safe_name(entry.orig_filename): entry for entry in entries}
        if len(self._entries) != len(entries):
            raise RequestError("xjdf.same-names")
        self.root = self._read(_root_name(list(self._entries), kind), LARGEST)

    def file(self, url: str) -> bytes:
        """Return a file of the package; URLs begin at the root of the package."""
        parts = urlsplit(url)
        name = unquote(parts.path).removeprefix("./")
        if parts.scheme or parts.netloc or name not in self._entries:
            raise RequestError("xjdf.no-file", url=url[:200])
        return self._read(name, self._limit)

    def _read(self, name: str, limit: int) -> bytes:
        method = self._entries[name].compress_type
        if method not in _METHODS:
            reason = f"the method of compression {method} is not supported"
            raise RequestError("xjdf.bad-package", reason=reason)
        try:
            # The size in the directory may be wrong: the decompressed bytes are counted.
            with self._zip.open(self._entries[name]) as file:
                content = file.read(limit + 1)
        except _ZIP_FAULTS as reason:
            raise RequestError("xjdf.bad-package", reason=_DAMAGED) from reason
        if len(content) > limit:
            raise RequestError("xjdf.too-large", name=name, limit=limit >> 20)
        return content


class MimePackage:
    """A package as MIME multipart/related; the first part, or that of ``start``, is the document.

    Parameters
    ----------
    content
        The package.
    media
        Content-Type of the request.

    Raises
    ------
    RequestError
        The package has no parts, or too many, or cannot be parsed.
    """

    def __init__(self, content: bytes, media: str) -> None:
        head = f"Content-Type: {media}\r\n\r\n".encode("latin-1", "replace")
        try:
            self._read(head + content)
        except _MIME_FAULTS as reason:
            reason_text = "its parts cannot be read"
            raise RequestError("xjdf.bad-package", reason=reason_text) from reason

    def _read(self, text: bytes) -> None:
        message = BytesParser(policy=policy.HTTP).parsebytes(text)
        assert isinstance(message, EmailMessage)
        parts = list(message.iter_parts()) if message.is_multipart() else []
        if not parts:
            raise RequestError("xjdf.no-parts")
        if len(parts) > _MOST_FILES:
            raise RequestError("xjdf.many-files", limit=_MOST_FILES)
        self._parts: dict[str, MIMEPart] = {}
        for part in parts:
            for name in _part_names(part):
                self._parts.setdefault(name, part)
        start = str(message.get_param("start", "")).strip("<> ")
        first = self._parts.get(f"cid:{start}") if start else parts[0]
        if first is None:
            raise RequestError("xjdf.no-file", url=f"cid:{start}"[:200])
        self.root = _payload(first)

    def file(self, url: str) -> bytes:
        """Return a file of the package by cid: and Content-ID, or by Content-Location."""
        part = self._parts.get(url) or self._parts.get(unquote(url))
        if part is None:
            raise RequestError("xjdf.no-file", url=url[:200])
        return _payload(part)


def open_package(content: bytes, media: str, limit: int, kind: str) -> XjdfPackage:
    """Return the document in the body of a request with the files of its package.

    Parameters
    ----------
    content
        Body of the request.
    media
        Its Content-Type.
    limit
        Largest size of a file (bytes).
    kind
        Expected document: XJDF or XJMF.

    Raises
    ------
    RequestError
        The package cannot be read.
    """
    wanted = media.partition(";")[0].strip().lower()
    if wanted == MIME:
        return MimePackage(content, media)
    if wanted in ZIP_TYPES or content.startswith(_ZIP_START):
        return ZipPackage(content, limit, kind)
    return SingleDocument(content)


def _safe_name(name: str) -> str:
    """Return the name of a file in a package; raise ``RequestError`` for a path outside of it."""
    path = PurePosixPath(name)
    if (
        path.is_absolute()
        or ".." in path.parts
        or "\\" in name
        or ":" in name
        or not name.isprintable()
    ):
        raise RequestError("xjdf.bad-name", name="".join(filter(str.isprintable, name))[:200])
    return name


def _root_name(names: list[str], kind: str) -> str:
    if kind == "XJMF":
        if ROOT_XJMF not in names:
            raise RequestError("xjdf.wrong-count", names=ROOT_XJMF, count=0)
        return ROOT_XJMF
    found = [name for name in names if name.lower().endswith(".xjdf")]
    if len(found) != 1:
        raise RequestError("xjdf.wrong-count", names="*.xjdf", count=len(found))
    return found[0]


def _part_names(part: MIMEPart) -> list[str]:
    """Return the URLs of a part."""
    id, location = str(part.get("Content-ID", "")).strip("<> "), part.get("Content-Location", "")
    return [*([f"cid:{id}"] if id else []), *([str(location)] if location else [])]


def _payload(part: MIMEPart) -> bytes:
    content = None if part.is_multipart() else part.get_payload(decode=True)
    if not isinstance(content, bytes):
        raise RequestError("xjdf.nested-parts")
    return content
