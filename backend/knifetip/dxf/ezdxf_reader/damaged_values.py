"""damaged_values: find values in a DXF file that ezdxf would change without a message.

When ezdxf repairs a file, it reads as many digits of a value as it can: "160,875" becomes 160.  It
skips a vertex of which one coordinate is missing.  A drawing with such a value would have a wrong
shape, so the file is refused.  Only entities from which edges are made are checked, and layers,
which may hide them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from knifetip.dxf.ezdxf_reader.entities import READ
from knifetip.dxf.value_types import DECIMAL, INTEGER, TYPE
from knifetip.errors import NotADrawing

#: Kinds of entities and table records that are checked; a POLYLINE with its vertices.
CHECKED: Final = frozenset([*READ, "BLOCK", "INSERT", "LAYER"])
_NUMBER: Final = re.compile(rb"\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*")
#: Mask of the group codes of numbers.
_IS_NUMBER: Final[list[bool]] = ((TYPE == DECIMAL) | (TYPE == INTEGER)).tolist()
#: Group code from which on the tags of an entity are data of other programs.
_EXTENSION: Final = 1000
_COMMENT: Final = 999
#: Group codes of the x coordinates of the vertices of these kinds; y must follow x directly.
_VERTICES: Final = {"LWPOLYLINE": (10,), "SPLINE": (10, 11)}
_LONGEST_SHOWN: Final = 40


def find_damaged_value(
    kind: str, codes: Sequence[int], values: Sequence[bytes], lines_before: int = 0
) -> NotADrawing | None:
    """Return an error for the first damaged value of an entity; None if all values are valid.

    Parameters
    ----------
    kind
        Kind of the entity, one of ``CHECKED``.
    codes, values
        Group codes and values of the tags of the entity, as written.
    lines_before
        Number of lines of the file before the first of these tags.
    """
    x_codes = _VERTICES.get(kind, ())
    previous = previous_line = -1
    for tag, (code, value) in enumerate(zip(codes, values, strict=True)):
        line = lines_before + 2 * tag + 1
        # The extension data of a POLYLINE precede its vertices.
        if code >= _EXTENSION or code == _COMMENT:
            continue
        if code >= 0 and _IS_NUMBER[code] and not _NUMBER.fullmatch(value):
            text = value[:_LONGEST_SHOWN].decode("ascii", "replace").strip()
            return NotADrawing("dxf.not-a-number", line=line + 1, code=code, kind=kind, text=text)
        if previous in x_codes and code != previous + 10:
            return _unpaired(kind, previous, previous_line)
        if code - 10 in x_codes and previous != code - 10:
            return _unpaired(kind, code, line)
        previous, previous_line = code, line
    return _unpaired(kind, previous, previous_line) if previous in x_codes else None


def _unpaired(kind: str, code: int, line: int) -> NotADrawing:
    return NotADrawing("dxf.coordinate-alone", line=line, code=code, kind=kind)
