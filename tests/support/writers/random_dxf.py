"""Hypothesis strategy for DXF files: what drawing programs write, in their various spellings.

First the entities are drawn with their group codes; then they are written as text in one of many
ways: version, line ends, blanks around group codes, spelling of numbers, comments, extra groups.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

from hypothesis import strategies as st

Tag: TypeAlias = tuple[int, Any]
Draw: TypeAlias = Callable[..., Any]

LAYERS = (
    *("0", "CUT", "Crease", "SCHNEIDEN ÄÖ", "折线", "Off", "frozen", "NoPlot", "NoTable"),
    "DefPoints",
)
LINETYPES = ("Continuous", "DASHED", "BYLAYER", "ByBlock")
#: Values of group 370; other programs write those that the format does not define, too.
LINE_WIDTHS = (-3, -2, -1, 0, 18, 50, 17, 300, -7)
BLOCKS = ("PANEL", "Flap", "*U1", "hole", "NEST", "EMPTY")
OLD, NEW = ("AC1009",), ("AC1015", "AC1018", "AC1021", "AC1024", "AC1027", "AC1032")

coordinates = st.one_of(
    st.integers(-3000, 3000).map(float),
    st.floats(-3000.0, 3000.0, allow_subnormal=False).map(lambda x: round(x, 3)),
    st.floats(-3000.0, 3000.0),
)
sizes = st.one_of(st.integers(1, 500).map(float), st.floats(0.01, 500.0))
angles = st.one_of(st.integers(-8, 16).map(lambda n: 45.0 * n), st.floats(-720.0, 720.0))


@dataclass(frozen=True)
class Spelling:
    """How a program writes DXF tags as text."""

    version: str
    end: str
    padded: bool
    exponents: bool
    comments: bool
    groups: bool
    handles: bool
    markers: bool  #: subclass markers, also in R12, which does not define them

    @property
    def new(self) -> bool:
        return self.version in NEW

    def number(self, value: float) -> str:
        if self.exponents:
            return f"{value:.17E}"
        text = repr(value)
        return text[:-1] if text.endswith(".0") else text

    def tags(self, *pairs: Tag) -> str:
        lines = []
        for code, value in pairs:
            if self.comments and code == 8:
                lines.append(f"999{self.end}a comment{self.end}")
            number = self.number(value) if isinstance(value, float) else str(value)
            lines.append(f"{code:>3}{self.end}" if self.padded else f"{code}{self.end}")
            lines.append(f"{number}{self.end}")
        return "".join(lines)


@st.composite
def spellings(draw: Draw) -> Spelling:
    return Spelling(
        draw(st.sampled_from(OLD * 4 + NEW)),
        draw(st.sampled_from(("\n", "\r\n"))),
        *(draw(st.booleans()) for _ in range(6)),
    )


@st.composite
def _common(draw: Draw, new: bool) -> list[Tag]:
    """Draw the tags of layer, linetype, colour and line width; all but the layer may be missing."""
    tags: list[Tag] = [(8, draw(st.sampled_from(LAYERS)))]
    if draw(st.booleans()):
        tags.append((6, draw(st.sampled_from(LINETYPES))))
    if draw(st.booleans()):
        tags.append((62, draw(st.sampled_from((0, 1, 3, 7, 255, 256)))))
    if new and draw(st.integers(0, 3)) == 0:
        tags.append((420, draw(st.integers(0, 0xFFFFFF))))
    if draw(st.integers(0, 2)) == 0:
        tags.append((370, draw(st.sampled_from(LINE_WIDTHS))))
    if draw(st.integers(0, 9)) == 0:
        tags.append((67, draw(st.sampled_from((0, 1)))))
    if draw(st.integers(0, 9)) == 0:
        tags.append((60, draw(st.sampled_from((0, 1)))))
    return tags


def _z(draw: Draw) -> float:
    z: float = draw(st.sampled_from((0.0, 0.0, 0.0, 0.0, 12.5)))
    return z


def _side(draw: Draw) -> list[Tag]:
    if draw(st.integers(0, 4)):
        return []
    return [(210, 0.0), (220, 0.0), (230, draw(st.sampled_from((1.0, -1.0))))]


def _point(draw: Draw, code: int, z: float | None = 0.0) -> list[Tag]:
    tags: list[Tag] = [(code, draw(coordinates)), (code + 10, draw(coordinates))]
    return tags if z is None else [*tags, (code + 20, z)]


@st.composite
def _line(draw: Draw, new: bool) -> list[list[Tag]]:
    z = _z(draw)
    rise = draw(st.sampled_from((0.0,) * 9 + (3.0,)))
    flat = draw(st.booleans())
    ends = [*_point(draw, 10, None if flat else z), *_point(draw, 11, None if flat else z + rise)]
    return [[(0, "LINE"), *draw(_common(new)), (100, "AcDbLine"), *ends]]


@st.composite
def _round(draw: Draw, new: bool) -> list[list[Tag]]:
    side = _side(draw)
    tags = [(100, "AcDbCircle"), *_point(draw, 10, _z(draw)), (40, draw(sizes))]
    if draw(st.booleans()):
        return [[(0, "CIRCLE"), *draw(_common(new)), *tags, *side]]
    turn: list[Tag] = [(100, "AcDbArc"), (50, draw(angles)), (51, draw(angles))]
    if draw(st.booleans()):
        return [[(0, "ARC"), *draw(_common(new)), *tags, *turn, *side]]
    return [[(0, "ARC"), *draw(_common(new)), *tags, *side, *turn]]


def _vertices(draw: Draw) -> list[tuple[float, float, float]]:
    bulges = st.sampled_from((0.0, 0.0, 0.5, -0.4142135623730951, 1.0, 2.5, -3.0))
    vertex = st.tuples(coordinates, coordinates, bulges)
    found: list[tuple[float, float, float]] = draw(st.lists(vertex, min_size=1, max_size=5))
    return found


polyline_widths = st.sampled_from((0.5, 0.5, 0.25, 0.0, -1.0, 0.782700154027225))


def _vertex_widths(draw: Draw) -> st.SearchStrategy[list[Tag]]:
    """Return a strategy for the widths of a vertex: of one polyline, they are often the same."""
    width = draw(polyline_widths)
    both: list[Tag] = [(40, width), (41, width)]
    ways: tuple[list[list[Tag]], ...] = (
        [[]],
        [both],
        [both, [], both[:1], both[1:], [(40, draw(polyline_widths))]],
    )
    return st.sampled_from(draw(st.sampled_from(ways)))


@st.composite
def _lwpolyline(draw: Draw, new: bool) -> list[list[Tag]]:
    if not new and draw(st.booleans()):
        rows: list[list[Tag]] = draw(_polyline(new))
        return rows
    vertices = _vertices(draw)
    tags: list[Tag] = [(100, "AcDbPolyline"), (90, len(vertices)), (70, draw(st.integers(0, 1)))]
    if (z := _z(draw)) != 0.0:
        tags.append((38, z))
    if draw(st.integers(0, 3)) == 0:
        tags.append((43, draw(polyline_widths)))
    vertex_widths = _vertex_widths(draw)
    for x, y, bulge in vertices:
        tags.extend([(10, x), (20, y), *draw(vertex_widths)])
        if bulge:
            tags.append((42, bulge))
    return [[(0, "LWPOLYLINE"), *draw(_common(new)), *tags, *_side(draw)]]


@st.composite
def _polyline(draw: Draw, new: bool) -> list[list[Tag]]:
    common = draw(_common(new))
    layer = common[0]
    three = draw(st.integers(0, 5)) == 0
    flags = draw(st.integers(0, 1)) | (8 if three else 0)
    z = _z(draw)
    rows: list[list[Tag]] = [
        [
            (0, "POLYLINE"),
            *common,
            (100, "AcDb3dPolyline" if three else "AcDb2dPolyline"),
            (66, 1),
            (10, 0.0),
            (20, 0.0),
            (30, z),
            *draw(_vertex_widths(draw)),
            (70, flags),
            *_side(draw),
        ]
    ]
    vertex_widths = _vertex_widths(draw)
    for x, y, bulge in _vertices(draw):
        marker = "AcDb3dPolylineVertex" if three else "AcDb2dVertex"
        vertex: list[Tag] = [(0, "VERTEX"), layer, (100, "AcDbVertex"), (100, marker)]
        vertex += [(10, x), (20, y), (30, z), *draw(vertex_widths)]
        if bulge and not three:
            vertex.append((42, bulge))
        rows.append([*vertex, (70, 32)] if three else vertex)
    return [*rows, [(0, "SEQEND"), layer]]


@st.composite
def _curve(draw: Draw, new: bool) -> list[list[Tag]]:
    """Draw an ellipse or a spline, also for R12, which does not define them."""
    common = draw(_common(new))
    if draw(st.booleans()):
        angle, size = draw(angles), draw(sizes)
        major: list[Tag] = [
            (11, size * math.cos(math.radians(angle))),
            (21, size * math.sin(math.radians(angle))),
            (31, 0.0),
        ]
        tags = [(100, "AcDbEllipse"), *_point(draw, 10, _z(draw)), *major, *_side(draw)]
        tags += [(40, draw(st.floats(0.05, 1.0)))]
        first, sweep = draw(st.floats(0.0, 6.0)), draw(st.sampled_from((2.0 * math.pi, 1.0, 4.0)))
        return [[(0, "ELLIPSE"), *common, *tags, (41, first), (42, first + sweep)]]
    points = [(draw(coordinates), draw(coordinates)) for _ in range(draw(st.integers(4, 6)))]
    inner = [float(n) for n in range(1, len(points) - 3)]
    knots = [0.0] * 4 + inner + [len(points) - 3.0] * 4
    tags = [(100, "AcDbSpline"), (70, 8), (71, 3), (72, len(knots)), (73, len(points)), (74, 0)]
    tags += [(40, knot) for knot in knots]
    tags += [tag for x, y in points for tag in ((10, x), (20, y), (30, 0.0))]
    return [[(0, "SPLINE"), *common, *tags]]


@st.composite
def _text(draw: Draw, new: bool) -> list[list[Tag]]:
    text = draw(st.sampled_from(("250 mm", "%%c 12.5", "\\A1;{\\fArial|b0;Cut} 3^J", "a\\Pb", "")))
    common = draw(_common(new))
    kind = draw(st.sampled_from(("TEXT", "DIMENSION") + (("MTEXT",) if new else ())))
    place = _point(draw, 10)
    if kind == "DIMENSION":
        return [
            [
                (0, kind),
                *common,
                (100, "AcDbDimension"),
                (2, "*D1"),
                *place,
                *_point(draw, 11),
                (70, draw(st.sampled_from((32, 33, 34, 37, 0)))),
                *([(1, text)] if draw(st.booleans()) else []),
                *([(42, draw(sizes))] if draw(st.booleans()) else []),
                (100, "AcDbAlignedDimension"),
                *_point(draw, 13),
                *_point(draw, 14),
            ]
        ]
    marker = "AcDbText" if kind == "TEXT" else "AcDbMText"
    xdata: list[Tag] = []
    if draw(st.integers(0, 3)) == 0:
        xdata = [(1001, "AcadAnnotative"), (1000, "AnnotativeData"), (1002, "{"), (1002, "}")]
    chunk: list[Tag] = [(3, "x" * 250)] if kind == "MTEXT" and draw(st.integers(0, 3)) == 0 else []
    tags = [(100, marker), *place, (40, draw(sizes)), *chunk, (1, text)]
    again: list[Tag] = [(100, "AcDbText")] if kind == "TEXT" and new else []
    return [[(0, kind), *common, *tags, *again, *xdata]]


@st.composite
def _unusual_entity(draw: Draw, new: bool) -> list[list[Tag]]:
    kind, marker = draw(st.sampled_from((("POINT", "AcDbPoint"), ("SOLID", "AcDbTrace"))))
    tags = [
        t for code in ((10,) if kind == "POINT" else (10, 11, 12, 13)) for t in _point(draw, code)
    ]
    return [[(0, kind), *draw(_common(new)), (100, marker), *tags]]


@st.composite
def _insert(draw: Draw, new: bool, names: tuple[str, ...] = BLOCKS) -> list[list[Tag]]:
    name = draw(st.sampled_from(names))
    tags = [(100, "AcDbBlockReference"), (2, name), *_point(draw, 10, _z(draw))]
    scale = draw(st.sampled_from((1.0, 1.0, 2.0, 0.5, -1.0, 25.4)))
    other = draw(st.sampled_from((1.0, 1.0, 1.0, -1.0, 0.5)))
    if scale != 1.0 or other != 1.0:
        tags += [(41, scale), (42, scale * other), (43, scale)]
    if draw(st.booleans()):
        tags.append((50, draw(angles)))
    if draw(st.integers(0, 5)) == 0:
        tags += [(70, draw(st.integers(1, 3))), (71, draw(st.integers(1, 3)))]
        tags += [(44, draw(sizes)), (45, draw(sizes))]
    return [[(0, "INSERT"), *draw(_common(new)), *tags, *_side(draw)]]


def _entity(new: bool, plain: bool) -> st.SearchStrategy[list[list[Tag]]]:
    usual = (_line(new), _line(new), _round(new), _lwpolyline(new), _polyline(new))
    return st.one_of(*usual, _text(new), _unusual_entity(new), *(() if plain else (_curve(new),)))


def _entity_text(
    spelling: Spelling, rows: list[list[Tag]], draw: Draw, next_handle: list[int]
) -> str:
    """Return the text of an entity and of the records that belong to it, such as vertices."""
    text = []
    for row in rows:
        kind, *rest = row
        tags = [kind]
        if spelling.handles or spelling.new:
            next_handle[0] += 1
            tags.append((5, f"{next_handle[0]:X}"))
        if spelling.groups and spelling.new and kind[1] != "INSERT":
            tags += [(102, "{ACAD_REACTORS"), (330, "1F"), (102, "}")]
        marks = spelling.new or (spelling.markers and kind[1] in ("LWPOLYLINE", "SPLINE"))
        if marks:
            tags.append((100, "AcDbEntity"))
        tags += [tag for tag in rest if tag[0] != 100 or marks]
        if spelling.groups and kind[1] not in ("MTEXT",):
            tags += [(1001, "KNIFETIP"), (1000, "note"), (1040, 2.5), (1070, 7)]
        text.append(spelling.tags(*tags))
    return "".join(text)


@st.composite
def drawings(draw: Draw, plain: bool = False) -> bytes:
    """Draw the bytes of a DXF file; ``plain`` excludes ellipses and splines."""
    spelling = draw(spellings())
    new = spelling.new
    tags = spelling.tags
    handle = [0x100]
    unit = draw(st.sampled_from((None, 0, 1, 4, 4, 4, 6)))
    header = tags((9, "$ACADVER"), (1, spelling.version))
    if unit is not None:
        header += tags((9, "$INSUNITS"), (70, unit))
    table = tags((0, "TABLE"), (2, "LAYER"), (70, 3))
    for name, colour, flags in (
        ("0", draw(st.sampled_from((7, 7, -7))), 0),
        ("CUT", 1, 0),
        ("Crease", 5, 0),
        ("Off", -3, 0),
        ("frozen", 2, 1),
        ("NoPlot", 4, 0),
        ("SCHNEIDEN ÄÖ", 6, 0),
    ):
        handle[0] += 1
        marks: list[Tag] = []
        if new:
            marks = [(5, f"{handle[0]:X}"), (100, "AcDbSymbolTableRecord")]
            marks.append((100, "AcDbLayerTableRecord"))
        extra: list[Tag] = [(420, 0x123456)] if new and name == "Crease" else []
        if name == "NoPlot":
            extra = [(290, 0)]
        if draw(st.integers(0, 2)) == 0:
            extra.append((370, draw(st.sampled_from(LINE_WIDTHS))))
        table += tags(
            (0, "LAYER"), *marks, (2, name), (70, flags), (62, colour), *extra, (6, "DASHED")
        )
    table += tags((0, "ENDTAB"))
    entity = _entity(new, plain)
    blocks = ""
    for name in BLOCKS:
        inside = [] if name == "EMPTY" else draw(st.lists(entity, max_size=3))
        if name == "NEST":
            inside += draw(st.lists(_insert(new, BLOCKS[:3]), max_size=2))
        base = draw(st.sampled_from(((0.0, 0.0), (5.0, -2.5))))
        marks = [(100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockBegin")] if new else [(8, "0")]
        handle[0] += 1
        blocks += tags(
            (0, "BLOCK"), (5, f"{handle[0]:X}"), *marks, (2, name), (70, 0), (10, base[0])
        )
        blocks += tags((20, base[1]), (30, 0.0), (3, name), (1, ""))
        blocks += "".join(_entity_text(spelling, rows, draw, handle) for rows in inside)
        marks = [(100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockEnd")] if new else [(8, "0")]
        handle[0] += 1
        blocks += tags((0, "ENDBLK"), (5, f"{handle[0]:X}"), *marks)
    several = draw(st.lists(st.one_of(entity, entity, entity, _insert(new)), max_size=8))
    entities = "".join(_entity_text(spelling, rows, draw, handle) for rows in several)
    sections = (("HEADER", header), ("TABLES", table), ("BLOCKS", blocks), ("ENTITIES", entities))
    text = "".join(
        tags((0, "SECTION"), (2, name)) + body + tags((0, "ENDSEC")) for name, body in sections
    )
    encoding: str = draw(st.sampled_from(("utf-8", "utf-8-sig")))
    whole: bytes = (text + tags((0, "EOF"))).encode(encoding)
    return whole
