"""rewrite: a DXF written so that ezdxf finds in it what it says.

    lines of a DXF -> the same lines, each LWPOLYLINE and SPLINE with its markers
    lines of a DXF -> the same lines without the entities of which no line is made
    tags of a binary DXF -> lines

ezdxf looks for the geometry of LWPOLYLINE and SPLINE behind their subclass markers only, and in a
file of R12, which knows neither of them, for everything else before the markers: layer, colour, and
whether they are closed.  Programs write them into such files all the same, and leave the markers
out.  And ezdxf refuses a whole file over one hatch or picture that it cannot make sense of.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, NamedTuple

from ezdxf.lldxf.types import DXFTag

from knifetip.dxf.entities import READ

#: The last version that knows no markers.
UNMARKED: Final = "AC1009"

_MARKERS: Final = {b"LWPOLYLINE": b"AcDbPolyline", b"SPLINE": b"AcDbSpline"}
#: Groups that every entity may have; they are not repeated behind the marker.
_COMMON: Final = frozenset(
    {5, 6, 8, 48, 60, 62, 67, 330, 347, 348, 360, 370, 380, 390, 410, 420, 430, 440, 999}
)
#: From this code on stands what other programs have added.
_ADDED: Final = 1000

#: What stays where entities stand: what lines are made of, and what holds it together.
_KEPT: Final = frozenset(
    [
        *(kind.encode() for kind in READ),
        *(b"INSERT", b"VERTEX", b"SEQEND", b"BLOCK", b"ENDBLK", b"SECTION", b"ENDSEC", b"EOF"),
    ]
)


class _Records(NamedTuple):
    """The lines of a DXF, parted at each group 0."""

    lines: list[bytes]
    codes: list[int]  #: of each tag, which has two lines
    spans: list[tuple[int, int]]  #: of tags, from one group 0 to the next

    def name(self, tag: int) -> bytes:
        return self.lines[2 * tag + 1].strip()

    def text(self, tags: Iterable[int]) -> list[bytes]:
        return [line for tag in tags for line in self.lines[2 * tag : 2 * tag + 2]]

    def joined(self, made: list[bytes]) -> bytes:
        """Return the lines that were made of the spans, with what stands around them."""
        first = self.lines[: 2 * self.spans[0][0]]
        return b"\n".join([*first, *made, *self.lines[2 * len(self.codes) :]])


def with_markers(data: bytes, *, every: bool = False) -> bytes:
    """Return the lines with markers; the same where none are missing, or the lines are no tags.

    Parameters
    ----------
    every
        Also those that have markers: what stands behind these stands before them too.
    """
    records = _records(data)
    if records is None:
        return data
    made: list[bytes] = []
    for tag, after in records.spans:
        marker = _MARKERS.get(records.name(tag))
        if marker is None or (100 in records.codes[tag:after] and not every):
            made.extend(records.text(range(tag, after)))
            continue
        head, own, added = _parted(records, tag, after)
        made.extend(records.text(head))
        made.extend((b"100", b"AcDbEntity", b"100", marker))
        made.extend(records.text(own))
        made.extend(records.text(added))
    return records.joined(made)


def lines_only(data: bytes) -> bytes:
    """Return the lines of a DXF without the entities of which no line is made.

    The census has counted them, and the ledger says of each why it is left out.
    """
    records = _records(data)
    if records is None:
        return data
    made: list[bytes] = []
    section = b""
    for tag, after in records.spans:
        name = records.name(tag).upper()
        if name == b"SECTION":
            section = records.name(tag + 1).upper() if tag + 1 < after else b""
        if name in _KEPT or section not in (b"ENTITIES", b"BLOCKS"):
            made.extend(records.text(range(tag, after)))
    return records.joined(made)


def as_text(tags: Iterable[DXFTag], encoding: str) -> bytes:
    """Return the tags of a binary DXF as the lines of a text."""
    lines: list[str] = []
    for tag in tags:
        value = tag.value
        said = value.hex().upper() if isinstance(value, bytes) else str(value)
        lines += (str(tag.code), " ".join(said.splitlines()))
    return "\n".join([*lines, ""]).encode(encoding, "replace")


def _records(data: bytes) -> _Records | None:
    """Part the lines; None where they are no tags, or begin nothing."""
    lines = data.split(b"\n")
    try:
        codes = list(map(int, lines[: len(lines) // 2 * 2 : 2]))
    except ValueError:
        return None
    starts = [tag for tag, code in enumerate(codes) if code == 0]
    if not starts:
        return None
    return _Records(lines, codes, list(zip(starts, [*starts[1:], len(codes)], strict=True)))


def _parted(records: _Records, tag: int, after: int) -> tuple[list[int], list[int], range]:
    """Return the tags of an entity without markers, those of its own kind, and what is added."""
    codes = records.codes
    end = next((n for n in range(tag, after) if codes[n] >= _ADDED), after)
    head = [n for n in range(tag, end) if codes[n] != 100]
    own = []
    in_group = False
    for n in head[1:]:
        if codes[n] == 102:
            in_group = records.name(n).startswith(b"{")
        elif not in_group and codes[n] not in _COMMON:
            own.append(n)
    return head, own, range(end, after)
