"""Answers that are bytes, and the names under which browsers save them."""

from __future__ import annotations

import re
from typing import Any

from fastapi import Response

BINARY: dict[str, Any] = {
    "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}
}


def bytes_response(content: bytes, tag: str, media: str, attachment: str = "") -> Response:
    """Return a response with bytes and their ETag, for a route that declares ``NOT_MODIFIED``.

    Parameters
    ----------
    content
        The bytes.
    tag
        ETag without quotation marks.
    media
        Media type.
    attachment
        Name under which a browser saves the bytes; "" to let the browser show them.
    """
    headers = {"ETag": f'"{tag}"', "Cache-Control": "no-cache"}
    if attachment:
        headers["Content-Disposition"] = f'attachment; filename="{file_name(attachment)}"'
    return Response(content, media_type=media, headers=headers)


def file_name(name: str) -> str:
    """Return a portable file name made from a name.

    It consists of letters (A to Z), digits, dots, dashes and underscores.  One dash replaces each
    sequence of other characters.  Dots and dashes at both ends are removed, and only the last 100
    characters are kept.  The result is "knifetip" if nothing is left.
    """
    plain = re.sub(r"[^A-Za-z0-9._-]+", "-", name).strip("-.")
    return plain[-100:] or "knifetip"
