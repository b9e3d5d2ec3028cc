"""read: a CF2 (CFF2, Common File Format 2), the die maker's exchange format, as a Drawing.

    bytes -> Drawing: segments in mm, and a ledger row for every record, wherever it is called

The subroutine is the layer.  What a line is, is said by a number on which only few agree, so it
becomes a linetype that profiles can name: ``CF2 2 3pt`` is type 2 in 3-point rule, ``CF2 3 aux 8
2pt`` type 3 of auxiliary type 8.

    bytes -> records (sections) -> place (calls) -> Drawing
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.cf2.place import placed
from knifetip.cf2.records import Source, source
from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.errors import KnifetipError, NotADrawing
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import CURVE
from knifetip.messages import Message
from knifetip.model.drawing import Drawing, extents
from knifetip.model.unit import factor

#: What the record of the unit stands for.
_UNITS = {"UM": "mm", "UI": "in"}
#: Sizes that differ by less than this share are the same.
_SAME = 0.01


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing that a CF2 holds.

    Parameters
    ----------
    unit
        "mm", "in" …: stands above what the file says.

    Returns
    -------
    Drawing
        In mm; in file units with ``unit`` empty where neither the file nor the caller says one.

    Raises
    ------
    NotADrawing
        Not a CF2, cut short or damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is no unit.
    """
    given = factor(unit) if unit else 0.0
    limits.admit(len(data))
    try:
        with np.errstate(all="ignore"):
            return _read(source(_decoded(data), limits), unit or "", given, limits)
    except KnifetipError:
        raise
    except (ValueError, ArithmeticError, LookupError) as error:
        raise NotADrawing(
            "reading.unexpected", reason=type(error).__name__, format="CF2"
        ) from error


def _decoded(data: bytes) -> str:
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        text = data.decode("utf-16", "replace")
    else:
        try:
            text = data.removeprefix(b"\xef\xbb\xbf").decode("utf-8")
        except UnicodeDecodeError:
            text = data.decode("cp1252", "replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _read(found: Source, unit: str, given: float, limits: Limits) -> Drawing:
    stated = _UNITS.get(found.unit, "")
    chosen = unit or stated
    scale = given or (factor(stated) if stated else 0.0)
    tolerance = CURVE / (scale or 1.0)
    reach = REACH / (scale or 1.0)
    drawn = placed(found, np.eye(2), tolerance, limits)
    columns = drawn.columns(reach)
    evidence = found.unit or "the file has neither UM nor UI"
    if found.scale != (1.0, 1.0):
        counts, why = _scaled(found, extents(columns.ends, columns.bulge))
        evidence = f"{evidence}; {why}"
        if counts is None:
            chosen, scale = unit, given
        elif counts:
            drawn = placed(found, np.diag(found.scale), tolerance, limits)
            columns = drawn.columns(reach)
    source = Message("unit.in-file", statement=evidence)
    if unit:
        source = Message("unit.given")
    known = KnownUnit(scale, chosen, source, stated)
    return assemble(drawn.sheet, columns, drawn.styles, drawn.inscriptions, known)


def _scaled(found: Source, box: F64) -> tuple[bool | None, str]:
    """Return whether the SCALE of the file is still to be applied, None where that is open.

    Programs disagree: the corners LL and UR show what this one meant.
    """
    x, y = found.scale
    words = f"SCALE,{x:g},{y:g}"
    if not all(math.isfinite(one) and one != 0.0 for one in (x, y)):
        return False, f"{words} has no meaning and is left out"
    size = box[2:] - box[:2]
    if found.low is not None and found.high is not None:
        wanted = np.abs(np.array(found.high) - np.array(found.low))
        for factors, applied in ((np.ones(2), False), (np.abs([x, y]), True)):
            if (np.abs(size * factors - wanted) <= _SAME * np.maximum(wanted, 1e-9)).all():
                how = "applied" if applied else "not applied"
                return applied, f"{words} {how}: so the drawing is as large as LL and UR say"
    return None, f"{words} is not applied: LL and UR do not show what it means"
