"""records: the lines of a CF2 as sections: what is drawn in MAIN and in each subroutine.

    text -> Source: unit, scale and corners that the head states; a Section each

A record is a line of fields between commas::

    L, pointage, type, aux, x1, y1, x2, y2, bridges, width
    A, pointage, type, aux, x1, y1, x2, y2, xc, yc, direction, bridges, width
    T, pointage, type, aux, x, y, angle, height, width           the words follow on the next line
    C, subroutine, x, y, angle, x scale, y scale

Direction is 1 where the arc goes round to the left, -1 where it goes to the right; an arc that ends
where it starts is a whole circle.  Files by different programs differ in what they leave out: the
last fields, the mark at the end ($EOF), the ORDER section, blanks and capitals.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final, NamedTuple

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits

#: Fields that a record has at the least, and from which number on it has decimal commas in it.
_FIELDS: Final = {"L": (8, 13), "A": (11, 17)}
#: Words before the first comma that begin a section that draws.
_DRAWING: Final = ("MAIN", "SUB")


class Call(NamedTuple):
    """A subroutine drawn somewhere: scaled first, then turned, then moved."""

    row: int  #: of the section
    name: str
    place: tuple[float, float, float, float, float]  #: x, y, degrees, x scale, y scale


class Words(NamedTuple):
    """A text."""

    row: int  #: of the section
    text: str
    place: tuple[float, float, float]  #: x, y, height


@dataclass(slots=True)
class Section:
    """What is drawn in MAIN or in a subroutine: m rows of any kind, in the order of the file."""

    name: str
    entity: list[int] = field(default_factory=list)  #: (m,) which record of the file, from 1
    kind: list[str] = field(default_factory=list)  #: (m,) L, A, T, C, or an unknown word
    dropped: dict[int, str] = field(default_factory=dict)  #: row -> why it is left out
    line_row: list[int] = field(default_factory=list)
    line: list[list[str]] = field(default_factory=list)  #: fields of each L
    arc_row: list[int] = field(default_factory=list)
    arc: list[list[str]] = field(default_factory=list)  #: fields of each A
    calls: list[Call] = field(default_factory=list)
    words: list[Words] = field(default_factory=list)

    def row(self, entity: int, kind: str, dropped: str = "") -> int:
        """Add a row and return its number."""
        self.entity.append(entity)
        self.kind.append(kind)
        if dropped:
            self.dropped[len(self.kind) - 1] = dropped
        return len(self.kind) - 1


@dataclass(slots=True)
class Source:
    """A CF2 as it was read."""

    main: Section | None = None
    subs: dict[str, Section] = field(default_factory=dict)  #: by name in capitals
    unit: str = ""  #: "UM", "UI" or empty
    scale: tuple[float, float] = (1.0, 1.0)
    low: tuple[float, float] | None = None  #: LL
    high: tuple[float, float] | None = None  #: UR
    ended: bool = False  #: $EOF was met
    records: int = 0


def source(text: str, limits: Limits) -> Source:
    """Return what a CF2 holds.

    Raises
    ------
    NotADrawing
        Nothing in it is drawn, it stops inside a section, or its decimals are commas.
    DrawingTooLarge
        It has more records than the limit.
    """
    reading = _Reading(text, limits)
    reading.all()
    found = reading.source
    unfinished = [section for section in reading.open if section]
    if unfinished:
        raise NotADrawing("cf2.cut-short", line=reading.number, inside=unfinished[-1])
    if found.main is None and not found.subs:
        raise NotADrawing("cf2.empty")
    return found


class _Reading:
    def __init__(self, text: str, limits: Limits) -> None:
        self.source = Source()
        self.number = 0  # of the line
        self.open: list[str] = []  # sections that are not ended, in words
        self._limits = limits
        self._lines = iter(text.split("\n"))
        self._sections: list[Section | None] = []
        self._commas = 0

    def _next(self) -> Iterator[str]:
        for line in self._lines:
            self.number += 1
            stripped = line.strip(" \t\r\f\x00\x1a")
            if stripped:
                yield stripped

    def all(self) -> None:
        """Read to the end of the file, or to its end mark."""
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
            elif word in _DRAWING:
                self._begun(word, rest.strip().rstrip(",").strip())
            elif section is None and word not in ("$BOF", "V2", "V1", "V3", ""):
                # ORDER and other sections tell of the order: words up to their END.
                if word in ("L", "A", "T", "C"):
                    # No head at all: records to the end of the file.
                    section = self._main("")
                    self._sections.append(section)
                    self.open.append("")
                    self._record(section, word, line)
                else:
                    self._sections.append(None)
                    self.open.append(f"section {word[:20]}")
            elif section is not None:
                self._record(section, word, line)

    def _begun(self, word: str, name: str) -> None:
        if word == "MAIN":
            self._sections.append(self._main(name))
            self.open.append("MAIN")
        else:
            self._sections.append(self.source.subs.setdefault(name.upper(), Section(name)))
            self.open.append(f"subroutine {name[:40]}")

    def _main(self, name: str) -> Section:
        if self.source.main is None:
            self.source.main = Section(name or "MAIN")
        return self.source.main

    def _counted(self) -> int:
        self.source.records += 1
        if self.source.records > self._limits.entities:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limits.entities, format="CF2"
            )
        return self.source.records

    def _line(self, section: Section, line: str) -> None:
        """Read an L or an A."""
        kind = line[0].upper()
        fields = line.split(",")
        while not fields[-1].strip():
            del fields[-1]
        least, many = _FIELDS[kind]
        entity = self._counted()
        if least <= len(fields) < many:
            row = section.row(entity, kind)
            if kind == "L":
                section.line_row.append(row)
                section.line.append(fields)
            else:
                section.arc_row.append(row)
                section.arc.append(fields)
            return
        if len(fields) >= many:
            self._commas += 1
            if self._commas > 3:
                raise NotADrawing(
                    "cf2.decimal-commas",
                    line=self.number,
                    fields=len(fields),
                    record=kind,
                    expected=many - 3,
                )
        section.row(entity, kind, f"line {self.number} has {len(fields)} fields")

    def _record(self, section: Section | None, word: str, line: str) -> None:
        if section is None or word in ("L", "A"):
            if section is not None:
                self._line(section, word + line.strip()[1:].lstrip())
            return
        fields = [one.strip() for one in line.split(",")]
        if word in ("UM", "UI"):
            self.source.unit = word
        elif word in ("LL", "UR", "SCALE"):
            self._stated(word, fields)
        elif word == "C":
            self._call(section, fields)
        elif word == "T":
            self._words(section, fields)
        else:
            section.row(self._counted(), word[:20], "it is no kind of record that is read")

    def _stated(self, word: str, fields: list[str]) -> None:
        try:
            pair = float(fields[1]), float(fields[2])
        except (ValueError, IndexError):
            return
        if word == "LL":
            self.source.low = pair
        elif word == "UR":
            self.source.high = pair
        else:
            self.source.scale = pair

    def _call(self, section: Section, fields: list[str]) -> None:
        entity = self._counted()
        try:
            values = [float(number) for number in fields[2:7] if number]
        except ValueError as reason:
            section.row(entity, "C", f"line {self.number} cannot be read: {reason}")
            return
        x, y, angle, x_scale, y_scale = values + [0.0, 0.0, 0.0, 1.0, 1.0][len(values) :]
        row = section.row(entity, "C")
        name = fields[1] if len(fields) > 1 else ""
        section.calls.append(Call(row, name, (x, y, angle, x_scale, y_scale)))

    def _words(self, section: Section, fields: list[str]) -> None:
        row = section.row(self._counted(), "T", "text is not cut")
        words = next(self._next(), "")
        if words.upper() == "END":
            # A text without its words: what follows is the end of the section.
            self._sections.pop()
            self.open.pop()
            return
        try:
            x, y = float(fields[4]), float(fields[5])
            height = float(fields[7]) if len(fields) > 7 else 0.0
        except (ValueError, IndexError):
            return
        section.words.append(Words(row, words, (x, y, height)))
