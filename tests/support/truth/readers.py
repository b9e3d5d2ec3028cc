"""Compare the results of the two DXF readers, the fast one and ezdxf."""

from __future__ import annotations

from contextlib import suppress
from importlib import import_module
from unittest.mock import patch

from knifetip.errors import KnifetipError
from knifetip.model.drawing import Drawing, LocationBoxes

reading = import_module("knifetip.dxf.read")
ezdxf_reader = import_module("knifetip.dxf.ezdxf_reader.reader")

_COLUMNS = (
    *("ends", "bulge", "entity", "layer", "colour", "true_colour", "linetype"),
    *("line_width", "fit_error"),
)
_RECORDS = ("layers", "linetypes", "unit", "evidence", "stated")


def fast_reader_accepts(data: bytes) -> bool:
    """Return whether the fast reader accepts a file, without falling back to ezdxf."""
    wrapped = patch.object(ezdxf_reader, "read_with_ezdxf", wraps=ezdxf_reader.read_with_ezdxf)
    with wrapped as reference_reader, suppress(KnifetipError):
        reading.read(data)
    return not reference_reader.called


def read_by_both(data: bytes) -> tuple[Drawing | KnifetipError, Drawing | KnifetipError]:
    """Return the results of reading with the fast reader (and its fallback) and with ezdxf only.

    A result is the drawing, or the error if the file is refused.
    """
    results: list[Drawing | KnifetipError] = []
    for read_fast in (reading.read_fast, lambda *_: None):
        with patch.object(reading, "read_fast", read_fast):
            try:
                results.append(reading.read(data))
            except KnifetipError as error:
                results.append(error)
    return results[0], results[1]


def difference(a: Drawing | KnifetipError, b: Drawing | KnifetipError) -> str:
    """Return the first difference of two results of ``read_by_both``, "" if they are equal.

    Numbers are compared bit by bit.
    """
    if isinstance(a, KnifetipError) or isinstance(b, KnifetipError):
        same = type(a) is type(b) and str(a) == str(b)
        return "" if same else f"refused: {a!r} / {b!r}"
    for name in _COLUMNS:
        one, other = getattr(a, name), getattr(b, name)
        if one.shape != other.shape or one.tobytes() != other.tobytes():
            return f"{name}: {one.tolist()} / {other.tolist()}"
    for name in _RECORDS:
        if getattr(a, name) != getattr(b, name):
            return f"{name}: {getattr(a, name)} / {getattr(b, name)}"
    # NaN, the measure of a dimension without one, is not equal to itself; its repr is.
    if repr(a.annotations) != repr(b.annotations):
        return f"annotations: {a.annotations} / {b.annotations}"
    for name in ("handle", "kind", "layer", "reason"):
        left, right = getattr(a.import_report, name), getattr(b.import_report, name)
        if left != right:
            return f"import_report.{name}: {left} / {right}"
    for name in LocationBoxes._fields:
        one = getattr(a.import_report.location_boxes, name)
        other = getattr(b.import_report.location_boxes, name)
        if one.tobytes() != other.tobytes():
            return f"import_report.{name}: {one.tolist()} / {other.tolist()}"
    for name in ("outcome", "length"):
        left, right = getattr(a.import_report, name), getattr(b.import_report, name)
        if left.tobytes() != right.tobytes():
            return f"import_report.{name}: {left} / {right}"
    return ""
