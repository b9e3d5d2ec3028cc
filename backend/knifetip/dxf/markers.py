"""markers: subclass markers for entities that a program wrote without them.

    lines of a DXF -> the same lines, LWPOLYLINE and SPLINE with their markers

ezdxf finds the geometry of these two by their markers only; it is plain to see without.
"""

from __future__ import annotations

from typing import Final

_MARKERS: Final = {b"LWPOLYLINE": b"AcDbPolyline", b"SPLINE": b"AcDbSpline"}
#: Groups that every entity may have, which stand before the marker.
_COMMON: Final = frozenset(
    {5, 6, 8, 48, 60, 62, 67, 102, 330, 360, 370, 390, 410, 420, 430, 440, 999}
)


def with_markers(data: bytes) -> bytes:
    """Return the lines with markers; the same where none are missing, or the lines are no tags."""
    lines = data.split(b"\n")
    try:
        codes = list(map(int, lines[: len(lines) // 2 * 2 : 2]))
    except ValueError:
        return data
    if not codes:
        return data
    starts = [tag for tag, code in enumerate(codes) if code == 0]
    made: list[bytes] = lines[: 2 * starts[0]] if starts else list(lines)
    for tag, after in zip(starts, [*starts[1:], len(codes)], strict=True):
        marker = _MARKERS.get(lines[2 * tag + 1].strip())
        if marker is None or 100 in codes[tag:after]:
            made.extend(lines[2 * tag : 2 * after])
            continue
        common = [n for n in range(tag + 1, after) if codes[n] in _COMMON]
        own = [n for n in range(tag + 1, after) if codes[n] not in _COMMON]
        made.extend(lines[2 * tag : 2 * tag + 2])
        made.extend((b"100", b"AcDbEntity"))
        for number in common:
            made.extend(lines[2 * number : 2 * number + 2])
        made.extend((b"100", marker))
        for number in own:
            made.extend(lines[2 * number : 2 * number + 2])
    if starts:
        made.extend(lines[2 * len(codes) :])
    return b"\n".join(made)
