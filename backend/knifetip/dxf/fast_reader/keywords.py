"""keywords: the keywords of DXF with their numbers, and kernels that look them up in bytes."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.dxf.byte_scan import bytes_equal
from knifetip.geometry.columns import I64
from knifetip.kernels import U8_1, inline_kernel

#: A keyword's number is its index.
_WORDS: Final = (
    b"SECTION", b"ENDSEC", b"EOF", b"HEADER", b"TABLES", b"BLOCKS", b"ENTITIES", b"OBJECTS",
    b"CLASSES", b"THUMBNAILIMAGE", b"ACDSDATA", b"BLOCK", b"ENDBLK", b"TABLE", b"ENDTAB",
    b"VPORT", b"LTYPE", b"LAYER", b"STYLE", b"VIEW", b"UCS", b"APPID", b"DIMSTYLE",
    b"BLOCK_RECORD", b"VERTEX", b"SEQEND", b"LINE", b"ARC", b"CIRCLE", b"LWPOLYLINE",
    b"POLYLINE", b"INSERT", b"ELLIPSE", b"SPLINE", b"ATTRIB", b"TEXT", b"DIMENSION", b"MTEXT",
    b"AcDbEntity", b"AcDbLine", b"AcDbCircle", b"AcDbArc", b"AcDbPolyline", b"AcDb2dPolyline",
    b"AcDbVertex", b"AcDb2dVertex", b"AcDbBlockReference", b"Model", b"ACAD_MTEXT",
    b"{ACAD_XDICTIONARY", b"}", b"DICTIONARY",
)  # fmt: skip
(
    SECTION, ENDSEC, EOF, HEADER, TABLES, BLOCKS, ENTITIES, OBJECTS, CLASSES, THUMBNAILIMAGE,
    ACDSDATA, BLOCK, ENDBLK,
    TABLE, ENDTAB, VPORT, LTYPE, LAYER, STYLE, VIEW, UCS, APPID, DIMSTYLE, BLOCK_RECORD,
    VERTEX, SEQEND, LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, INSERT, ELLIPSE, SPLINE,
    ATTRIB, TEXT, DIMENSION, MTEXT, DB_ENTITY, DB_LINE, DB_CIRCLE, DB_ARC, DB_LWPOLYLINE,
    DB_POLYLINE, DB_VERTEX, DB_2D_VERTEX, DB_INSERT, MODEL, OF_COLUMNS, XDICTIONARY,
    GROUP_END, DICTIONARY,
) = range(len(_WORDS))  # fmt: skip
COUNT: Final = len(_WORDS)
# Padding, since eight bytes are read at a time.
_BYTES: Final = np.frombuffer(b"".join(_WORDS) + bytes(8), np.uint8)
ENDS: Final[I64] = np.cumsum([0, *map(len, _WORDS)])


@inline_kernel
def is_word(data: U8_1, low: int, high: int, word: int) -> bool:
    """Return whether the bytes ``data[low:high]`` are the keyword with number ``word``."""
    size = ENDS[word + 1] - ENDS[word]
    return bool(high - low == size and bytes_equal(data, low, _BYTES, ENDS[word], size))


@inline_kernel
def word_at(data: U8_1, low: int, high: int, first: int, last: int) -> Any:
    """Return the number of the keyword ``data[low:high]``.

    The result is -1 if these bytes are none of the keywords with numbers ``first`` … ``last``.
    """
    for word in range(first, last + 1):
        if is_word(data, low, high, word):
            return word
    return -1
