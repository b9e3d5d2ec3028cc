"""read: read a CF2 (CFF2, Common File Format 2), an exchange format of die makers.

``read`` returns a Drawing with segments in mm, and a row of the import report for every copy of a
record.

A CF2 has a main section and subroutines, which are sections that can be called several times.  The
name of a subroutine becomes the layer of its lines.  The type number of a line means cut, crease or
another operation, depending on the program that wrote the file.  Type number, auxiliary type and
thickness of the steel rule are therefore joined to a linetype name, to which the rules of a profile
refer.  ``CF2 2 3pt`` means type 2 in 3-point rule, and ``CF2 3 aux 8 2pt`` means type 3 with
auxiliary type 8 in 2-point rule.

``records`` parses the records into sections; ``expand`` replaces calls by copies of subroutines.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.cf2.expand import expand
from knifetip.cf2.records import Cf2File, parse_records
from knifetip.drawing_builder.assemble import KnownUnit, assemble
from knifetip.formats.limits import REACH, Limits
from knifetip.formats.refusals import refuse_unexpected
from knifetip.geometry.columns import F64
from knifetip.geometry.tolerance import CURVE
from knifetip.messages import Message
from knifetip.model.drawing import Drawing, extents

#: The unit of each unit record.
_UNITS = {"UM": "mm", "UI": "in"}
#: The message for each unit record, and for a file without one.
_EVIDENCE = {"UM": "unit.cf2-millimetres", "UI": "unit.cf2-inches", "": "unit.cf2-none"}
#: Reasons why a scale in the header is ignored although the size of the drawing may be wrong.
_UNEXPLAINED = ("unit.cf2-scale-invalid", "unit.cf2-scale-undecided")
#: Relative tolerance of sizes that are compared.
_SIZE_TOLERANCE = 0.01


def read(
    data: bytes,
    unit: str | None = None,
    *,
    limits: Limits = Limits(),
) -> Drawing:
    """Return the drawing in a CF2.

    Parameters
    ----------
    data
        Content of the file.
    unit
        The unit that the user gives, "mm", "in" …; it replaces the unit in the file.  None if the
        user gives no unit.
    limits
        Limits of the size of the file and of the drawing.

    Returns
    -------
    Drawing
        In mm.  If neither the file nor the user gives a unit, the drawing is in file units and its
        attribute ``unit`` is empty.

    Raises
    ------
    NotADrawing
        The file is not a CF2, or it is truncated or damaged.
    DrawingTooLarge
        A limit is exceeded.
    NoSuchUnit
        ``unit`` is not a unit.
    """
    with refuse_unexpected(data, unit, limits, "CF2"):
        return _build_drawing(parse_records(_decode(data), limits), unit, limits)


def _decode(data: bytes) -> str:
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        text = data.decode("utf-16", "replace")
    else:
        try:
            text = data.removeprefix(b"\xef\xbb\xbf").decode("utf-8")
        except UnicodeDecodeError:
            text = data.decode("cp1252", "replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _build_drawing(parsed: Cf2File, unit: str | None, limits: Limits) -> Drawing:
    stated = _UNITS.get(parsed.unit, "")
    evidence = Message(_EVIDENCE[parsed.unit])
    known = KnownUnit.choose(unit, stated, evidence)
    tolerance = CURVE / (known.scale or 1.0)
    reach = REACH / (known.scale or 1.0)
    expanded = expand(parsed, np.eye(2), tolerance, limits)
    columns = expanded.columns(reach)
    if parsed.scale != (1.0, 1.0):
        applies, reason = _scale_applies(parsed, extents(columns.ends, columns.bulge))
        evidence = Message("unit.cf2-scaled", unit=evidence, scale=reason)
        # A size that contradicts the header leaves the unit open.
        trusted = "" if applies is None else stated
        known = KnownUnit.choose(unit, trusted, evidence)._replace(stated=stated)
        if applies:
            expanded = expand(parsed, np.diag(parsed.scale), tolerance, limits)
            columns = expanded.columns(reach)
        if reason.code in _UNEXPLAINED:
            expanded.report.row("SCALE", "SCALE", "", reason)
    if not parsed.ended:
        expanded.report.row("$EOF", "$EOF", "", Message("import.no-end-mark", mark="$EOF"))
    return assemble(expanded.report, columns, expanded.styles, expanded.annotations, known)


def _scale_applies(source: Cf2File, box: F64) -> tuple[bool | None, Message]:
    """Return whether coordinates must be multiplied by the scale in the header, and the reason.

    Some programs multiply the coordinates before they write them, others do not.  The size of the
    drawing, with and without the scale, is compared with the size in the header (records LL and
    UR).  The first value is None if neither size agrees, or if the header contains no size.

    ``box`` (4,): min x, min y, max x and max y of the coordinates without the scale.
    """
    x, y = source.scale
    if not all(math.isfinite(one) and one != 0.0 for one in (x, y)):
        return False, Message("unit.cf2-scale-invalid", x=x, y=y)
    size = box[2:] - box[:2]
    if source.low is not None and source.high is not None:
        stated_size = np.abs(np.array(source.high) - np.array(source.low))
        for factors, applied in ((np.ones(2), False), (np.abs([x, y]), True)):
            if (
                np.abs(size * factors - stated_size)
                <= _SIZE_TOLERANCE * np.maximum(stated_size, 1e-9)
            ).all():
                code = "unit.cf2-scale-applied" if applied else "unit.cf2-scale-not-applied"
                return applied, Message(code, x=x, y=y)
    return None, Message("unit.cf2-scale-undecided", x=x, y=y)
