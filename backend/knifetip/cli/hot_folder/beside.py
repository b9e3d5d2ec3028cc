"""Drawings beside orders in XJDF: a document names its drawing by a URL relative to the folder."""

from __future__ import annotations

import stat
import zipfile
from io import BytesIO
from pathlib import Path, PurePosixPath
from typing import Final
from urllib.parse import unquote, urlsplit

from knifetip.errors import KnifetipError

#: Date of the entries in a package, so that the same files are the same package.
_DATE: Final = (1980, 1, 1, 0, 0, 0)


def drawing_beside(document: bytes) -> str:
    """Return the path in the folder of the drawing that an XJDF document names; "" for none.

    Errors of the document are left to the server, which explains them.
    """
    # Imported here: only orders in XJDF need the parser.
    from knifetip.service.xjdf.order import read_order

    try:
        url = urlsplit(read_order(document).file)
    except (KnifetipError, ValueError):
        return ""
    name = unquote(url.path).removeprefix("./")
    path = PurePosixPath(name)
    is_outside = path.is_absolute() or ".." in path.parts
    if url.scheme or is_outside or not name.isprintable() or set("\\:") & set(name):
        return ""
    return name


def find_beside(folder: Path, name: str) -> Path | None:
    """Return the path of a drawing in a folder; None if it is missing, a link or outside of it."""
    path = folder / name
    try:
        is_file = stat.S_ISREG(path.lstat().st_mode)
        is_inside = path.resolve().is_relative_to(folder.resolve())
    except OSError:
        return None
    return path if is_file and is_inside else None


def pack_order(document: bytes, name: str, drawing: bytes) -> bytes:
    """Return an order in XJDF and its drawing as a ZIP package."""
    content = BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as package:
        for path, data in (("order.xjdf", document), (name, drawing)):
            package.writestr(zipfile.ZipInfo(path, _DATE), data, zipfile.ZIP_DEFLATED)
    return content.getvalue()
