"""read: read a DXF file, ASCII or binary, of any version, as a Drawing.

The fast reader is tried first; a file that it does not support is read with ezdxf.
"""

from __future__ import annotations

import re
from typing import Final

import numpy as np

from knifetip.dxf.fast_reader.reader import read_fast
from knifetip.errors import KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.model.drawing import Drawing
from knifetip.model.unit import factor

__all__ = ["Limits", "read"]

#: Pattern of the first bytes of an ASCII DXF file.
_CODE: Final = re.compile(rb" *\d")


def read(data: bytes, unit: str | None = None, *, limits: Limits = Limits()) -> Drawing:
    """Return the drawing in a DXF file.

    Parameters
    ----------
    data
        Content of the file, ASCII or binary.
    unit
        Unit that replaces the unit of the file: "mm", "cm", "m", "in" or "ft"; None or empty for
        the unit of the file.

    Returns
    -------
    Drawing
        In mm.  If neither the file nor ``unit`` names a unit, the drawing is in file units, and its
        attribute ``unit`` is empty.

    Raises
    ------
    NotADrawing
        The file is empty, is not a DXF file, or is damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is unknown.
    """
    if unit:
        factor(unit)  # refuses an unknown one
    limits.admit(len(data))
    data, lines_before = _strip_start(data)
    try:
        with np.errstate(all="ignore"):
            drawing = read_fast(data, unit or "", limits)
            if drawing is None:
                # ezdxf is slow to import, and most files do not need it.
                from knifetip.dxf.ezdxf_reader.reader import read_with_ezdxf

                drawing = read_with_ezdxf(data, unit or "", limits, lines_before)
            return drawing
    except KnifetipError:
        raise
    except Exception as error:
        # ezdxf may raise anything on hostile bytes; a user's file must not end in a traceback.
        from knifetip.dxf.ezdxf_reader.document import describe_error

        reason = f"{type(error).__name__}: {describe_error(error)}"
        raise NotADrawing("reading.damaged", format="DXF", reason=reason) from error


def _strip_start(data: bytes) -> tuple[bytes, int]:
    """Return the content of a file without byte order mark and without leading blank lines.

    Content in UTF-16 is converted to UTF-8.  The second value is the number of lines removed.
    """
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", "replace").encode("utf-8")
    # Most files begin with a group code and are not copied.
    if _CODE.match(data):
        return data, 0
    data = data.removeprefix(b"\xef\xbb\xbf")
    stripped = data.lstrip()
    return stripped, data[: len(data) - len(stripped)].count(b"\n")
