"""rewrite: change the text lines of a DXF file so that ezdxf reads all of its geometry.

``with_markers`` adds subclass markers to LWPOLYLINE and SPLINE, ``lines_only`` removes entities
that have no geometry to cut, and ``as_text`` converts the tags of a binary DXF file to lines.

ezdxf expects the geometry of LWPOLYLINE and SPLINE after their subclass markers.  In files of
version R12, which does not define these entities, ezdxf expects layer, colour and the closed flag
before the markers.  Many programs write LWPOLYLINE and SPLINE without markers, or into R12 files.
ezdxf also refuses a whole file because of one hatch or image that it cannot parse.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, NamedTuple

from ezdxf.lldxf.types import DXFTag

from knifetip.dxf.ezdxf_reader.entities import READ

#: The last version without subclass markers.
UNMARKED: Final = "AC1009"

_MARKERS: Final = {b"LWPOLYLINE": b"AcDbPolyline", b"SPLINE": b"AcDbSpline"}
#: Group codes that all kinds of entities have; their tags are not repeated after the marker.
_COMMON: Final = frozenset(
    {5, 6, 8, 48, 60, 62, 67, 330, 347, 348, 360, 370, 380, 390, 410, 420, 430, 440, 999}
)
#: From this group code on, data is extension data of other programs.
_ADDED: Final = 1000

#: Records that are kept: entities with geometry, and the structure of the file.
_READ_KINDS: Final = frozenset(
    [
        *(kind.encode() for kind in READ),
        *(b"INSERT", b"VERTEX", b"SEQEND", b"BLOCK", b"ENDBLK", b"SECTION", b"ENDSEC", b"EOF"),
    ]
)


class _Records(NamedTuple):
    """The lines of a DXF file, split into records; each record starts with a group code 0."""

    lines: list[bytes]
    codes: list[int]  #: group code of each tag (two lines)
    spans: list[tuple[int, int]]  #: first tag of each record, and the tag after its last

    def name(self, tag: int) -> bytes:
        return self.lines[2 * tag + 1].strip()

    def text(self, tags: Iterable[int]) -> list[bytes]:
        return [line for tag in tags for line in self.lines[2 * tag : 2 * tag + 2]]

    def join_records(self, new_lines: list[bytes]) -> bytes:
        """Return the content of the file with its records replaced by the lines ``new_lines``.

        The lines before the first record and after the last tag are kept.
        """
        first = self.lines[: 2 * self.spans[0][0]]
        return b"\n".join([*first, *new_lines, *self.lines[2 * len(self.codes) :]])


def with_markers(data: bytes, *, every: bool = False) -> bytes:
    """Return the DXF file ``data`` with subclass markers added to its LWPOLYLINEs and SPLINEs.

    The markers are inserted after the tags of each such entity and before its extension data.  The
    tags specific to the kind of the entity, such as coordinates, are repeated after the markers,
    because ezdxf expects them there.  A file that cannot be split into records is returned
    unchanged.

    Parameters
    ----------
    every
        Whether entities that already have markers are rewritten too; otherwise they are unchanged.
    """
    records = _records(data)
    if records is None:
        return data
    new_lines: list[bytes] = []
    for tag, end in records.spans:
        marker = _MARKERS.get(records.name(tag))
        if marker is None or (100 in records.codes[tag:end] and not every):
            new_lines.extend(records.text(range(tag, end)))
            continue
        head, own, added = _split_tags(records, tag, end)
        new_lines.extend(records.text(head))
        new_lines.extend((b"100", b"AcDbEntity", b"100", marker))
        new_lines.extend(records.text(own))
        new_lines.extend(records.text(added))
    return records.join_records(new_lines)


def lines_only(data: bytes) -> bytes:
    """Return the DXF file ``data`` without the entities that have no geometry to cut.

    The import report still lists the removed entities, because they are counted before this call.
    """
    records = _records(data)
    if records is None:
        return data
    new_lines: list[bytes] = []
    section = b""
    for tag, end in records.spans:
        name = records.name(tag).upper()
        if name == b"SECTION":
            section = records.name(tag + 1).upper() if tag + 1 < end else b""
        if name in _READ_KINDS or section not in (b"ENTITIES", b"BLOCKS"):
            new_lines.extend(records.text(range(tag, end)))
    return records.join_records(new_lines)


def as_text(tags: Iterable[DXFTag], encoding: str) -> bytes:
    """Return the tags of a binary DXF file as the content of an ASCII DXF file in ``encoding``."""
    lines: list[str] = []
    for tag in tags:
        value = tag.value
        text = value.hex().upper() if isinstance(value, bytes) else str(value)
        lines += (str(tag.code), " ".join(text.splitlines()))
    return "\n".join([*lines, ""]).encode(encoding, "replace")


def _records(data: bytes) -> _Records | None:
    """Return the lines of the DXF file ``data`` split into records.

    None if the lines are not pairs of a group code and a value, or if no group code is 0.
    """
    lines = data.split(b"\n")
    try:
        codes = list(map(int, lines[: len(lines) // 2 * 2 : 2]))
    except ValueError:
        return None
    starts = [tag for tag, code in enumerate(codes) if code == 0]
    if not starts:
        return None
    return _Records(lines, codes, list(zip(starts, [*starts[1:], len(codes)], strict=True)))


def _split_tags(records: _Records, tag: int, tag_end: int) -> tuple[list[int], list[int], range]:
    """Return indices into ``records.codes`` of three selections of the tags of one entity.

    The tags of the entity have the indices ``tag`` … ``tag_end`` - 1.  Its extension data starts at
    the first tag with a group code of at least 1000.

    Returns ``head`` list: indices of all tags before the extension data, without subclass markers;
    ``own`` list: those indices in ``head`` whose tags are specific to the kind of the entity, such
    as its coordinates; ``added`` range: indices of the tags of the extension data.
    """
    codes = records.codes
    end = next((n for n in range(tag, tag_end) if codes[n] >= _ADDED), tag_end)
    head = [n for n in range(tag, end) if codes[n] != 100]
    own = []
    in_group = False
    for n in head[1:]:
        if codes[n] == 102:
            in_group = records.name(n).startswith(b"{")
        elif not in_group and codes[n] not in _COMMON:
            own.append(n)
    return head, own, range(end, tag_end)
