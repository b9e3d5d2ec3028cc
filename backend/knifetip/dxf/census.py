"""census: what a file holds, counted from its bytes before anybody interprets them.

    bytes -> Census: header variables, every entity of ENTITIES and of each block, in file order

The frame of the ledger.  ezdxf skips, repairs and adds entities, and fills in header variables
that the file does not have; here stands what the file itself says.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any, Final

from ezdxf.lldxf.tagger import binary_tags_loader

from knifetip.dxf.encoding import encoding_of, spelled
from knifetip.dxf.inscriptions import WORDS, of_tags
from knifetip.dxf.location_boxes import around
from knifetip.geometry.columns import F64
from knifetip.model.drawing import Inscription

#: The first bytes of a binary DXF.
BINARY: Final = b"AutoCAD Binary DXF\r\n\x1a\x00"
#: Rows of a table of their own, which belong to the POLYLINE or INSERT before them.
_PARTS: Final = frozenset({"VERTEX", "SEQEND"})


@dataclass(frozen=True, slots=True)
class Counted:
    """One entity as the file has it."""

    kind: str  #: LINE, ARC, INSERT …
    handle: str  #: empty where the file gives none
    layer: str
    paper: bool  #: it stands in paper space
    words: Inscription | None = None
    box: F64 | None = None  #: (4,) around its points, in its own coordinates, as ``standing`` says


@dataclass(slots=True)
class CountedBlock:
    """A block definition and what is in it."""

    name: str
    handle: str
    layer: str
    entities: list[Counted] = field(default_factory=list)


@dataclass(slots=True)
class Census:
    """Header variables, entities and blocks of a file."""

    sections: set[str] = field(default_factory=set)  #: names of the sections that it has
    variables: dict[str, str] = field(default_factory=dict)  #: $NAME -> its first value
    entities: list[Counted] = field(default_factory=list)
    blocks: dict[str, CountedBlock] = field(default_factory=dict)  #: by name in lower case
    encoding: str = "cp1252"
    markers: bool = False  #: entities have subclass markers, which R12 does not know
    unmarked: bool = False  #: an entity has none
    open_section: str = ""  #: the section that the file stops in, empty if all are closed
    ended: bool = False  #: the file has its end mark, EOF
    broken: int = 0  #: the line at which the file stops being a DXF, 0 if it does not

    @property
    def size(self) -> int:
        """How many entities there are, those of blocks included."""
        return len(self.entities) + sum(len(block.entities) for block in self.blocks.values())

    @property
    def inscriptions(self) -> tuple[Inscription, ...]:
        """The words that stand on the sheet."""
        return tuple(one.words for one in self.entities if one.words and not one.paper)


def census(data: bytes) -> Census:
    """Count what is in a DXF, ASCII or binary; never raises, whatever the bytes."""
    result = Census()
    codes, values = _binary_tags(data) if data.startswith(BINARY) else _ascii_tags(data, result)
    starts = [row for row, code in enumerate(codes) if code == 0]
    _header(codes, values, starts, result)
    result.encoding = encoding_of(data, result.variables)

    def text(value: Any) -> str:
        if isinstance(value, bytes):
            return spelled(value.decode(result.encoding, "replace").strip())
        return spelled(str(value).strip())

    section = ""
    block: CountedBlock | None = None
    for number, row in enumerate(starts):
        after = starts[number + 1] if number + 1 < len(starts) else len(codes)
        kind = text(values[row]).upper()
        if kind == "SECTION":
            named = row + 1 < after and codes[row + 1] == 2
            section = text(values[row + 1]).upper() if named else ""
            result.sections.add(section)
            block = None
        elif kind == "ENDSEC":
            section = ""
        elif kind == "EOF":
            result.ended = True
            break
        elif section in ("ENTITIES", "BLOCKS") and kind not in _PARTS:
            handle, layer, name, paper = "", "0", "", False
            marked = False
            for tag in range(row + 1, after):
                code = codes[tag]
                if code == 5 and not handle:
                    handle = text(values[tag]).upper()
                elif code == 8:
                    layer = text(values[tag])
                elif code == 2 and not name:
                    name = text(values[tag])
                elif code == 67:
                    paper = text(values[tag]) == "1"
                elif code == 100:
                    marked = True
            result.markers |= marked
            result.unmarked |= not marked
            words = None
            if kind in WORDS:
                tags = zip(codes[row + 1 : after], values[row + 1 : after], strict=True)
                words = of_tags(kind, layer, tags, result.encoding)
            last = _behind(kind, number, starts, values)
            span = slice(row + 1, starts[last] if last < len(starts) else len(codes))
            box = around(kind, codes[span], values[span])
            counted = Counted(kind, handle, layer, paper, words, box)
            if section == "ENTITIES":
                result.entities.append(counted)
            elif kind == "BLOCK":
                # Of two blocks of one name the last one counts, as it does for ezdxf.
                block = CountedBlock(name, handle, layer)
                result.blocks[name.lower()] = block
            elif kind == "ENDBLK":
                block = None
            elif block is not None:
                block.entities.append(counted)
    result.open_section = section
    _unpack_layouts(result)
    return result


def _behind(kind: str, number: int, starts: list[int], values: Sequence[Any]) -> int:
    """Return which entity comes next, behind the vertices of a POLYLINE."""
    number += 1
    if kind == "POLYLINE":
        while number < len(starts) and _plain(values[starts[number]]) == "VERTEX":
            number += 1
    return number


def _unpack_layouts(found: Census) -> None:
    """Count what the file keeps in the blocks of its layouts with the entities of the sheet."""
    for name in [
        name for name in found.blocks if name.startswith(("*model_space", "*paper_space"))
    ]:
        paper = name.startswith("*paper")
        for counted in found.blocks.pop(name).entities:
            found.entities.append(replace(counted, paper=paper or counted.paper))


def _ascii_tags(data: bytes, found: Census) -> tuple[list[int], list[bytes]]:
    lines = data.split(b"\n") if b"\n" in data else data.split(b"\r")
    values = lines[1::2]
    written = lines[0::2][: len(values)]
    try:
        return list(map(int, written)), values
    except ValueError:
        pass
    codes: list[int] = []
    for row, code in enumerate(written):
        try:
            codes.append(int(code))
        except ValueError:
            if not (codes and codes[-1] == 0 and values[row - 1].strip() == b"EOF"):
                found.broken = 2 * row + 1
            break
        if codes[-1] == 0 and values[row].strip() == b"EOF":
            break
    return codes, values


def _binary_tags(data: bytes) -> tuple[list[int], list[Any]]:
    codes: list[int] = []
    values: list[Any] = []
    # What comes before the damage is counted; reading the file reports the damage itself.
    with suppress(Exception):
        for tag in binary_tags_loader(data, errors="replace"):
            codes.append(tag.code)
            values.append(tag.value)
    return codes, values


def _header(codes: Sequence[int], values: Sequence[Any], starts: list[int], found: Census) -> None:
    """Collect the header variables; of a variable that is said twice, what is said first."""
    for number, row in enumerate(starts):
        after = starts[number + 1] if number + 1 < len(starts) else len(codes)
        if row + 1 >= after or codes[row + 1] != 2 or _plain(values[row]) != "SECTION":
            continue
        if _plain(values[row + 1]) != "HEADER":
            continue
        for tag in range(row + 2, after - 1):
            if codes[tag] == 9:
                found.variables.setdefault(_plain(values[tag]), _plain(values[tag + 1]))


def header_of(section: bytes) -> dict[str, str]:
    """Return the variables of a section HEADER, from its text; of one said twice, the first."""
    lines = section.split(b"\n")
    found: dict[str, str] = {}
    for row in range(0, len(lines) - 3, 2):
        if lines[row].strip().lstrip(b"0") == b"9":
            found.setdefault(_plain(lines[row + 1]), _plain(lines[row + 3]))
    return found


def _plain(value: Any) -> str:
    text = value.decode("ascii", "replace") if isinstance(value, bytes) else str(value)
    return text.strip().upper()
