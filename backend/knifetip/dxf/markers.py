"""markers: LWPOLYLINE and SPLINE written so that ezdxf finds what they say.

    lines of a DXF -> the same lines, each of these two with its markers

ezdxf looks for the geometry of these two behind their subclass markers only, and in a file of R12,
which knows neither of them, for everything else before the markers: layer, colour, and whether
they are closed.  Programs write them into such files all the same, and leave the markers out.
"""

from __future__ import annotations

from typing import Final

#: The last version that knows no markers.
UNMARKED: Final = "AC1009"

_MARKERS: Final = {b"LWPOLYLINE": b"AcDbPolyline", b"SPLINE": b"AcDbSpline"}
#: Groups that every entity may have; they are not repeated behind the marker.
_COMMON: Final = frozenset(
    {5, 6, 8, 48, 60, 62, 67, 330, 347, 348, 360, 370, 380, 390, 410, 420, 430, 440, 999}
)
#: From this code on stands what other programs have added.
_ADDED: Final = 1000


def with_markers(data: bytes, *, every: bool = False) -> bytes:
    """Return the lines with markers; the same where none are missing, or the lines are no tags.

    Parameters
    ----------
    every
        Also those that have markers: what stands behind these stands before them too.
    """
    lines = data.split(b"\n")
    try:
        codes = list(map(int, lines[: len(lines) // 2 * 2 : 2]))
    except ValueError:
        return data
    starts = [tag for tag, code in enumerate(codes) if code == 0]
    if not starts:
        return data
    made: list[bytes] = lines[: 2 * starts[0]]
    for tag, after in zip(starts, [*starts[1:], len(codes)], strict=True):
        marker = _MARKERS.get(lines[2 * tag + 1].strip())
        if marker is None or (100 in codes[tag:after] and not every):
            made.extend(lines[2 * tag : 2 * after])
            continue
        head, own, added = _parted(codes, lines, tag, after)
        made.extend(_lines(lines, head))
        made.extend((b"100", b"AcDbEntity", b"100", marker))
        made.extend(_lines(lines, own))
        made.extend(_lines(lines, added))
    made.extend(lines[2 * len(codes) :])
    return b"\n".join(made)


def _parted(
    codes: list[int], lines: list[bytes], tag: int, after: int
) -> tuple[list[int], list[int], range]:
    """Return the tags of an entity without markers, those of its own kind, and what is added."""
    end = next((n for n in range(tag, after) if codes[n] >= _ADDED), after)
    head = [n for n in range(tag, end) if codes[n] != 100]
    own = []
    in_group = False
    for n in head[1:]:
        if codes[n] == 102:
            in_group = lines[2 * n + 1].lstrip().startswith(b"{")
        elif not in_group and codes[n] not in _COMMON:
            own.append(n)
    return head, own, range(end, after)


def _lines(lines: list[bytes], tags: list[int] | range) -> list[bytes]:
    return [line for n in tags for line in lines[2 * n : 2 * n + 2]]
