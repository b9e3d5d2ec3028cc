"""prescan: count the entities in the bytes of a file before ezdxf reads it.

The prescan contains what is in the file: header variables, and every entity of the section ENTITIES
and of each block, in file order.  The import report is based on it, because ezdxf skips, repairs
and adds entities, and adds header variables that the file does not have.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any, Final

from knifetip.dxf.annotations import WORDS, annotation_of_tags
from knifetip.dxf.encoding import encoding_of, unescape
from knifetip.dxf.ezdxf_reader.damaged_values import CHECKED, find_damaged_value
from knifetip.dxf.location_boxes import box_of_tags
from knifetip.errors import NotADrawing
from knifetip.geometry.columns import F64
from knifetip.model.drawing import Annotation

#: The first bytes of a binary DXF.
BINARY: Final = b"AutoCAD Binary DXF\r\n\x1a\x00"
#: Entities that belong to the POLYLINE or INSERT before them.
_PARTS: Final = frozenset({"VERTEX", "SEQEND"})


@dataclass(frozen=True, slots=True)
class PrescannedEntity:
    """One entity as written in the file, before ezdxf reads the file."""

    kind: str  #: LINE, ARC, INSERT …
    handle: str  #: empty if the file gives no handle
    layer: str
    in_paper_space: bool
    words: Annotation | None = None
    box: F64 | None = None  #: (4,) bounding box, see ``location_boxes``


@dataclass(slots=True)
class PrescannedBlock:
    """One block definition as written in the file, before ezdxf reads it, with its entities."""

    name: str
    handle: str
    layer: str
    entities: list[PrescannedEntity] = field(default_factory=list)


@dataclass(slots=True)
class Prescan:
    """Header variables, entities and blocks as written in a file, and its structural defects."""

    sections: set[str] = field(default_factory=set)  #: names of the sections of the file
    variables: dict[str, str] = field(default_factory=dict)  #: first values by $NAME
    entities: list[PrescannedEntity] = field(default_factory=list)
    blocks: dict[str, PrescannedBlock] = field(default_factory=dict)  #: by name in lower case
    encoding: str = "cp1252"
    markers: bool = False  #: whether an entity has subclass markers, which R12 does not define
    unmarked: bool = False  #: whether an entity has no subclass markers
    open_section: str = ""  #: the section in which the file ends, "" if all are closed
    ended: bool = False  #: whether the file has the end mark EOF
    lines_before: int = 0  #: number of blank lines before the content
    broken: int = 0  #: number of the first line that is not DXF, 0 if there is none
    broken_text: str = ""  #: the beginning of this line
    damage: NotADrawing | None = None  #: the first value that ezdxf would change

    @property
    def size(self) -> int:
        """Number of all entities in model space, in paper space and in block definitions."""
        return len(self.entities) + sum(len(block.entities) for block in self.blocks.values())

    @property
    def annotations(self) -> tuple[Annotation, ...]:
        """The annotations of the texts and dimensions in model space."""
        return tuple(one.words for one in self.entities if one.words and not one.in_paper_space)


def prescan(data: bytes, lines_before: int = 0) -> Prescan:
    """Return the entities, blocks and header variables of a DXF file as written.

    They are read from the bytes of the file, ASCII or binary, before ezdxf repairs it.  A damaged
    file raises no exception; its defects are recorded in the result.  ``lines_before`` is the
    number of blank lines before ``data`` in the file; it is added to line numbers.
    """
    result = Prescan(lines_before=lines_before)
    is_binary = data.startswith(BINARY)
    codes, values = _binary_tags(data) if is_binary else _ascii_tags(data, result)
    starts = [row for row, code in enumerate(codes) if code == 0]
    _header(codes, values, starts, result)
    result.encoding = encoding_of(data, result.variables)

    def text(value: Any) -> str:
        if isinstance(value, bytes):
            return unescape(value.decode(result.encoding, "replace").strip())
        return unescape(str(value).strip())

    def check_values(kind: str, span: slice) -> None:
        # The numbers of a binary file are numbers.
        if kind in CHECKED and not (result.damage or is_binary):
            before = 2 * span.start + lines_before
            result.damage = find_damaged_value(kind, codes[span], values[span], before)

    section = ""
    block: PrescannedBlock | None = None
    for number, row in enumerate(starts):
        next_start = starts[number + 1] if number + 1 < len(starts) else len(codes)
        kind = text(values[row]).upper()
        if kind == "SECTION":
            named = row + 1 < next_start and codes[row + 1] == 2
            section = text(values[row + 1]).upper() if named else ""
            result.sections.add(section)
            block = None
        elif kind == "ENDSEC":
            section = ""
        elif kind == "EOF":
            result.ended = True
            break
        elif section == "TABLES":
            check_values(kind, slice(row + 1, next_start))
        elif section in ("ENTITIES", "BLOCKS") and kind not in _PARTS:
            handle, layer, name, paper = "", "0", "", False
            marked = False
            for tag in range(row + 1, next_start):
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
                tags = zip(codes[row + 1 : next_start], values[row + 1 : next_start], strict=True)
                words = annotation_of_tags(kind, layer, tags, result.encoding)
            last = _index_after(kind, number, starts, values)
            span = slice(row + 1, starts[last] if last < len(starts) else len(codes))
            box = box_of_tags(kind, codes[span], values[span])
            check_values(kind, span)
            counted = PrescannedEntity(kind, handle, layer, paper, words, box)
            if section == "ENTITIES":
                result.entities.append(counted)
            elif kind == "BLOCK":
                # The last of several blocks with one name counts, as in ezdxf.
                block = PrescannedBlock(name, handle, layer)
                result.blocks[name.lower()] = block
            elif kind == "ENDBLK":
                block = None
            elif block is not None:
                block.entities.append(counted)
    result.open_section = section
    _unpack_layouts(result)
    return result


def _index_after(kind: str, number: int, starts: list[int], values: Sequence[Any]) -> int:
    """Return the index in ``starts`` of the entity that follows the entity with index ``number``.

    The VERTEX entities after a POLYLINE are skipped, because they belong to the POLYLINE.

    ``kind``, ``number``: kind of the entity, and its index in ``starts``.
    ``starts``: index into ``values`` of the first tag of each entity.
    ``values``: values of all tags of the file.
    """
    number += 1
    if kind == "POLYLINE":
        while number < len(starts) and _upper_text(values[starts[number]]) == "VERTEX":
            number += 1
    return number


def _unpack_layouts(prescan_: Prescan) -> None:
    """Move the entities of the blocks *Model_Space and *Paper_Space to ``prescan_.entities``.

    A DXF file may contain the entities of model space and of paper space in these two blocks.
    Blocks with names such as *Paper_Space0 are treated in the same way.
    """
    for name in [
        name for name in prescan_.blocks if name.startswith(("*model_space", "*paper_space"))
    ]:
        paper = name.startswith("*paper")
        for counted in prescan_.blocks.pop(name).entities:
            prescan_.entities.append(
                replace(counted, in_paper_space=paper or counted.in_paper_space)
            )


def _ascii_tags(data: bytes, prescan_: Prescan) -> tuple[list[int], list[bytes]]:
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
                prescan_.broken = 2 * row + 1 + prescan_.lines_before
                prescan_.broken_text = code[:40].decode("ascii", "replace").strip()
            break
        if codes[-1] == 0 and values[row].strip() == b"EOF":
            break
    return codes, values


def _binary_tags(data: bytes) -> tuple[list[int], list[Any]]:
    from ezdxf.lldxf.tagger import binary_tags_loader  # slow to import

    codes: list[int] = []
    values: list[Any] = []
    # Entities before the damage are counted; the reader reports the damage.
    with suppress(Exception):
        for tag in binary_tags_loader(data, errors="replace"):
            codes.append(tag.code)
            values.append(tag.value)
    return codes, values


def _header(
    codes: Sequence[int], values: Sequence[Any], starts: list[int], prescan_: Prescan
) -> None:
    """Write the values of the header variables into ``prescan_.variables``.

    If a variable is repeated, its first value is written.

    ``codes``, ``values``: group codes and values of all tags of the file.
    ``starts``: indices of the tags with group code 0.
    """
    for number, row in enumerate(starts):
        next_start = starts[number + 1] if number + 1 < len(starts) else len(codes)
        if row + 1 >= next_start or codes[row + 1] != 2 or _upper_text(values[row]) != "SECTION":
            continue
        if _upper_text(values[row + 1]) != "HEADER":
            continue
        for tag in range(row + 2, next_start - 1):
            if codes[tag] == 9:
                prescan_.variables.setdefault(
                    _upper_text(values[tag]), _upper_text(values[tag + 1])
                )


def header_of(section: bytes) -> dict[str, str]:
    """Return the values of the header variables by name, given the bytes of the section HEADER.

    If a variable is repeated, its first value is returned.
    """
    lines, texts = section.split(b"\n"), section.decode("ascii", "replace").upper().split("\n")
    variables: dict[str, str] = {}
    for row in range(0, len(lines) - 3, 2):
        if lines[row].strip().lstrip(b"0") == b"9":
            variables.setdefault(texts[row + 1].strip(), texts[row + 3].strip())
    return variables


def _upper_text(value: Any) -> str:
    text = value.decode("ascii", "replace") if isinstance(value, bytes) else str(value)
    return text.strip().upper()
