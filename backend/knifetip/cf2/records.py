"""records: parse the records of a CF2 into sections, one for MAIN and one for each subroutine.

``parse_records`` returns a ``Cf2File``: the sections, and the unit, the scale and the corners of
the drawing from the header.

A record is one text line with fields between commas::

    L, pointage, type, aux, x1, y1, x2, y2, bridges, width
    A, pointage, type, aux, x1, y1, x2, y2, xc, yc, direction, bridges, width
    T, pointage, type, aux, x, y, angle, height, width
    C, subroutine, x, y, angle, x scale, y scale

L is a line, A an arc, T a text and C a call of a subroutine.  Pointage is the thickness of the
steel rule in points, and aux an auxiliary type of the line.  In L and A, bridges is the number of
gaps in the rule, and width the width of each gap.  The text of a T record is the next line of the
file.  Direction is 1 for a counter-clockwise arc and -1 for a clockwise arc; an arc that ends at
its start is a whole circle.  Programs may omit the last fields, the end mark ($EOF) and the ORDER
section.  They also use blanks and capitals differently.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final, NamedTuple

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.messages import Message

#: Least number of fields of a record, and the least number that implies decimal commas.
_FIELDS: Final = {"L": (8, 13), "A": (11, 17)}
#: First fields of the sections that contain lines.
_SECTIONS_WITH_LINES: Final = ("MAIN", "SUB")


class Call(NamedTuple):
    """A record that draws a scaled, rotated and moved copy of a subroutine."""

    row: int  #: of the section
    name: str
    placement: tuple[float, float, float, float, float]  #: x, y, degrees, x scale, y scale


class TextRecord(NamedTuple):
    """A text on the drawing, with its position and height."""

    row: int  #: of the section
    text: str
    placement: tuple[float, float, float]  #: x, y, height


@dataclass(slots=True)
class Section:
    """The m records of MAIN or of one subroutine of a CF2, in the order of the file."""

    name: str
    entity: list[int] = field(
        default_factory=list
    )  #: (m,) number of the record in the file, from 1
    kind: list[str] = field(default_factory=list)  #: (m,) L, A, T, C, or an unknown first field
    dropped: dict[int, Message] = field(
        default_factory=dict
    )  #: row -> reason why the record is dropped
    line_row: list[int] = field(default_factory=list)
    line: list[list[str]] = field(default_factory=list)  #: fields of each L record
    arc_row: list[int] = field(default_factory=list)
    arc: list[list[str]] = field(default_factory=list)  #: fields of each A record
    calls: list[Call] = field(default_factory=list)
    texts: list[TextRecord] = field(default_factory=list)

    def row(self, entity: int, kind: str, drop_reason: Message | None = None) -> int:
        """Add a record to the section and return the index of the record in the section.

        Parameters
        ----------
        entity
            Number of the record in the file, from 1.
        kind
            First field of the record: L, A, T, C or an unknown word.
        drop_reason
            Reason why the record is dropped, None if it is kept.
        """
        self.entity.append(entity)
        self.kind.append(kind)
        if drop_reason:
            self.dropped[len(self.kind) - 1] = drop_reason
        return len(self.kind) - 1


@dataclass(slots=True)
class Cf2File:
    """The content of a CF2 file: its sections, and the unit, scale and corners in its header."""

    main: Section | None = None
    subs: dict[str, Section] = field(default_factory=dict)  #: by upper-case name
    unit: str = ""  #: "UM", "UI" or empty
    scale: tuple[float, float] = (1.0, 1.0)
    low: tuple[float, float] | None = None  #: lower left corner (record LL)
    high: tuple[float, float] | None = None  #: upper right corner (record UR)
    ended: bool = False  #: whether $EOF was found
    records: int = 0


def parse_records(text: str, limits: Limits) -> Cf2File:
    """Return the header and the sections of a CF2, whose content is ``text``.

    Raises
    ------
    NotADrawing
        The file has no section, ends inside a section, or has decimal commas.
    DrawingTooLarge
        The number of records exceeds the limit.
    """
    parser = _Parser(text, limits)
    parser.parse_all()
    source = parser.source
    unfinished = [section for section in parser.open if section]
    if unfinished:
        raise NotADrawing("cf2.cut-short", line=parser.number, inside=unfinished[-1])
    if source.main is None and not source.subs:
        raise NotADrawing("cf2.empty")
    return source


def parse_number(text: str) -> float:
    """Return the number that is written in ``text``.

    Raises
    ------
    ValueError
        ``text`` is not a number.  Python's ``float`` would accept "1_0".
    """
    if "_" in text:
        raise ValueError(text)
    return float(text)


class _Parser:
    """Parses the text lines of one CF2 into sections."""

    def __init__(self, text: str, limits: Limits) -> None:
        self.source = Cf2File()
        self.number = 0  # number of the current text line, from 1
        #: Sections that have not ended; None for records without a section.
        self.open: list[Message | None] = []
        self._limits = limits
        self._lines = iter(text.split("\n"))
        self._sections: list[Section | None] = []
        self._commas = 0

    def _next(self) -> Iterator[str]:
        """Yield the remaining text lines that are not blank, without white space at their ends."""
        for line in self._lines:
            self.number += 1
            stripped = line.strip(" \t\r\f\x00\x1a")
            if stripped:
                yield stripped

    def parse_all(self) -> None:
        """Parse the file to its end, or to its end mark ($EOF)."""
        for line in self._next():
            section = self._sections[-1] if self._sections else None
            if section is not None and line[:2] in ("L,", "A,", "l,", "a,"):
                self._line(section, line)
                continue
            word, _, rest = line.partition(",")
            word = word.strip().upper()
            if word == "$EOF":
                self.source.ended = True
                return
            if word == "END":
                if self._sections:
                    self._sections.pop()
                    self.open.pop()
            elif self._sections and section is None:
                continue
            elif word in _SECTIONS_WITH_LINES:
                self._begin_section(word, rest.strip().rstrip(",").strip())
            elif section is None and word not in ("$BOF", "V2", "V1", "V3", ""):
                # ORDER and other sections contain text up to their END.
                if word in ("L", "A", "T", "C"):
                    # The file has no header: records follow to its end.
                    section = self._main("")
                    self._sections.append(section)
                    self.open.append(None)
                    self._record(section, word, line)
                else:
                    self._sections.append(None)
                    self.open.append(Message("cf2.section", name=word[:20]))
            elif section is not None:
                self._record(section, word, line)

    def _begin_section(self, word: str, name: str) -> None:
        if word == "MAIN":
            self._sections.append(self._main(name))
            self.open.append(Message("cf2.main"))
        else:
            self._sections.append(self.source.subs.setdefault(name.upper(), Section(name)))
            self.open.append(Message("cf2.subroutine", name=name[:40]))

    def _main(self, name: str) -> Section:
        if self.source.main is None:
            self.source.main = Section(name or "MAIN")
        return self.source.main

    def _next_number(self) -> int:
        """Count a record and return its number in the file, from 1.

        Raises ``DrawingTooLarge``: the file has more records than the limit.
        """
        self.source.records += 1
        if self.source.records > self._limits.entities:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limits.entities, format="CF2"
            )
        return self.source.records

    def _line(self, section: Section, line: str) -> None:
        """Parse the record of a line (L) or an arc (A) and add it to a section.

        ``line`` is the text line that contains the record.
        """
        kind = line[0].upper()
        fields = line.split(",")
        while not fields[-1].strip():
            del fields[-1]
        least, too_many = _FIELDS[kind]
        entity = self._next_number()
        if least <= len(fields) < too_many:
            row = section.row(entity, kind)
            if kind == "L":
                section.line_row.append(row)
                section.line.append(fields)
            else:
                section.arc_row.append(row)
                section.arc.append(fields)
            return
        if len(fields) >= too_many:
            self._commas += 1
            if self._commas > 3:
                raise NotADrawing(
                    "cf2.decimal-commas",
                    line=self.number,
                    fields=len(fields),
                    record=kind,
                    expected=too_many - 3,
                )
        section.row(
            entity, kind, Message("import.wrong-field-count", line=self.number, fields=len(fields))
        )

    def _record(self, section: Section | None, word: str, line: str) -> None:
        if section is None or word in ("L", "A"):
            if section is not None:
                self._line(section, word + line.strip()[1:].lstrip())
            return
        fields = [one.strip() for one in line.split(",")]
        if word in ("UM", "UI"):
            self.source.unit = word
        elif word in ("LL", "UR", "SCALE"):
            self._header(section, word, fields)
        elif word == "C":
            self._call(section, fields)
        elif word == "T":
            self._text(section, fields)
        else:
            section.row(self._next_number(), word[:20], Message("import.unknown-record"))

    def _header(self, section: Section, word: str, fields: list[str]) -> None:
        try:
            pair = parse_number(fields[1]), parse_number(fields[2])
        except (ValueError, IndexError):
            section.row(self._next_number(), word, self._not_numbers(fields[1:3]))
            return
        if word == "LL":
            self.source.low = pair
        elif word == "UR":
            self.source.high = pair
        else:
            self.source.scale = pair

    def _call(self, section: Section, fields: list[str]) -> None:
        entity = self._next_number()
        texts = [*fields[2:7], *[""] * 5][:5]
        try:
            x, y, angle = (parse_number(text or "0") for text in texts[:3])
            x_scale, y_scale = (parse_number(text or "1") for text in texts[3:])
        except ValueError:
            section.row(entity, "C", self._not_numbers(fields[2:7]))
            return
        row = section.row(entity, "C")
        name = fields[1] if len(fields) > 1 else ""
        section.calls.append(Call(row, name, (x, y, angle, x_scale, y_scale)))

    def _not_numbers(self, fields: list[str]) -> Message:
        shown = [text[:20] for text in fields]
        return Message("import.line-not-numbers", line=self.number, values=shown)

    def _text(self, section: Section, fields: list[str]) -> None:
        row = section.row(self._next_number(), "T", Message("import.text"))
        text = next(self._next(), "")
        if text.upper() == "END":
            # The text is missing, so this END is the end of the section.
            self._sections.pop()
            self.open.pop()
            return
        try:
            x, y = float(fields[4]), float(fields[5])
            height = float(fields[7]) if len(fields) > 7 else 0.0
        except (ValueError, IndexError):
            return
        section.texts.append(TextRecord(row, text, (x, y, height)))
