"""Compressed responses: whether a client accepts gzip, and gzip data in pieces."""

from __future__ import annotations

import re
import zlib
from collections.abc import Iterable, Iterator, Mapping
from typing import Final

_ACCEPTS_GZIP: Final = re.compile(
    r"(?:^|,)\s*(?:gzip|\*)\s*(?:;\s*q=(?!0(?:\.0*)?\s*(?:,|$))[^,]*)?(?:,|$)"
)
#: Window size of zlib for data with the header of gzip.
_GZIP: Final = 31
#: Above this level, JSON of edges takes twice the time and becomes a tenth smaller.
_LEVEL: Final = 4
_PIECE: Final = 1 << 14  # bytes of gzip data that are unpacked at a time


def accepts_gzip(headers: Mapping[str, str]) -> bool:
    """Return whether a client takes compressed responses; a part of a file is not compressed.

    Parameters
    ----------
    headers
        Headers of the request, by name in lower case.
    """
    accepted = headers.get("accept-encoding", "")
    return "range" not in headers and _ACCEPTS_GZIP.search(accepted) is not None


def pack(pieces: Iterable[bytes]) -> bytes:
    """Return the pieces of a text as gzip data; equal texts give equal data."""
    packer = zlib.compressobj(_LEVEL, wbits=_GZIP)
    return b"".join([*(packer.compress(piece) for piece in pieces), packer.flush()])


def unpack(content: bytes) -> Iterator[bytes]:
    """Yield the content of gzip data in pieces; other threads can run between two pieces."""
    unpacker = zlib.decompressobj(wbits=_GZIP)
    for first in range(0, len(content), _PIECE):
        yield unpacker.decompress(content[first : first + _PIECE])
    yield unpacker.flush()
