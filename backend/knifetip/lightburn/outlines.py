"""outlines: the lines and curves of the shapes of a LightBurn project.

A path consists of vertices and of primitives that join them.  In .lbrn2 both are packed into texts:

    V10 0c0x15c0y5c1x1V20 0c0x1c1x15c1y-5       vertices with up to two control points
    L0 1B1 0                                    lines and Bézier curves between vertices

``LineClosed`` instead of primitives joins all vertices in their order by lines, and the last one
with the first one.  Without c0y, "c0x1" states that a vertex has no control point, and c0y is 0
beside any other c0x.  A curve leaves its first vertex towards c0 and reaches the second one from
c1.  In .lbrn there is an element for each vertex (V) and each primitive (P).
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Final, NamedTuple

from knifetip.drawing_builder.shape_paths import Shape
from knifetip.errors import DrawingTooLarge
from knifetip.formats.invalid_content import InvalidContent
from knifetip.formats.limits import Limits
from knifetip.lightburn.project import ProjectShape
from knifetip.messages import Message

#: A number; without backtracking, because a text may have millions of digits.
_NUMBER: Final = r"[-+]?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE][-+]?\d++)?"
_VERTEX: Final = re.compile(rf"\s*V\s*({_NUMBER})\s+({_NUMBER})((?:c[01][xy]{_NUMBER}|\s*S)*)\s*")
_CONTROL: Final = re.compile(rf"(c[01][xy])({_NUMBER})")
_PRIMITIVE: Final = re.compile(r"\s*([LB])\s*(\d{1,9})\s+(\d{1,9})\s*")
_ONE_NUMBER: Final = re.compile(_NUMBER)
#: Texts instead of primitives: lines through all vertices, closed or open.
_CHAINS: Final = {"LineClosed": True, "LineOpen": False}
#: Flag of an arc with increasing angles.
_RISING: Final = 2.0
#: Greatest number of characters of a file in a message.
_MAX_SHOWN: Final = 12


class Vertex(NamedTuple):
    """A vertex of a path, with its control points; a control point may be the vertex itself."""

    x: float
    y: float
    leaving: tuple[float, float]  #: control point c0, for the curve that begins at the vertex
    reaching: tuple[float, float]  #: control point c1, for the curve that ends at the vertex


class Outlines:
    """Outlines of shapes; vertices and primitives with a number are shared by several shapes.

    Parameters
    ----------
    limits
        Limits of the number of segments.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._vertices: dict[str, list[Vertex]] = {}
        self._primitives: dict[str, str] = {}
        self._shapes: dict[tuple[str, str], Shape] = {}

    def outline(self, shape: ProjectShape) -> Shape | None:
        """Return the outline of a shape in its own coordinates, None for an unknown type.

        Raises
        ------
        InvalidContent
            The shape is damaged.
        DrawingTooLarge
            The shape has more vertices or primitives than the limit of segments.
        """
        make = _TYPES.get(shape.kind)
        return None if make is None else make(self, shape)

    def path(self, one: ProjectShape) -> Shape:
        """Return the outline of a path."""
        vertex_id, primitive_id = (one.attributes.get(key, "") for key in ("VertID", "PrimID"))
        vertices_here, primitives_here = (one.texts.get(key) for key in ("VertList", "PrimList"))
        if vertices_here is None and primitives_here is None and (one.vertices or not vertex_id):
            return self._legacy_path(one)
        vertices = (
            self._parse_vertices(vertices_here)
            if vertices_here is not None
            else self._vertices.get(vertex_id)
        )
        primitives = (
            primitives_here if primitives_here is not None else self._primitives.get(primitive_id)
        )
        if vertices is None or primitives is None:
            raise InvalidContent(
                "import.missing-id", id=vertex_id if vertices is None else primitive_id
            )
        if vertex_id and vertices_here is not None:
            self._vertices[vertex_id] = vertices
        if primitive_id and primitives_here is not None:
            self._primitives[primitive_id] = primitives
        is_shared = vertices_here is None and primitives_here is None
        key = (vertex_id, primitive_id)
        if is_shared and key in self._shapes:
            return self._shapes[key]
        shape = self._join(vertices, primitives)
        if vertex_id and primitive_id:
            self._shapes[key] = shape
        return shape

    def _legacy_path(self, shape: ProjectShape) -> Shape:
        vertices = [
            Vertex(
                x := _value(given, "vx"),
                y := _value(given, "vy"),
                _legacy_control(given, "c0", x, y),
                _legacy_control(given, "c1", x, y),
            )
            for given in shape.vertices
        ]
        joined = [
            (given.get("T", ""), _index(given, "p0"), _index(given, "p1"))
            for given in shape.primitives
        ]
        return _join_outline(vertices, joined)

    def _parse_vertices(self, text: str) -> list[Vertex]:
        """Return the vertices in the text ``VertList``."""
        self._check_count(text.count("V"))
        vertices = []
        for match in _matches(_VERTEX, text):
            x, y = float(match[1]), float(match[2])
            leaving = reaching = (x, y)
            if match[3]:
                control = dict(_CONTROL.findall(match[3]))
                leaving = _control(control.get("c0x"), control.get("c0y"), x, y)
                reaching = _control(control.get("c1x"), control.get("c1y"), x, y)
            vertices.append(Vertex(x, y, leaving, reaching))
        return vertices

    def _join(self, vertices: list[Vertex], primitives: str) -> Shape:
        """Return the lines and curves between vertices that the text ``PrimList`` states."""
        closed = _CHAINS.get(primitives.strip())
        if closed is not None:
            chain = vertices + vertices[:1] if closed else vertices
            points = [number for vertex in chain for number in vertex[:2]]
            return Shape(polylines=[points] if len(chain) > 1 else [])
        self._check_count(primitives.count("L") + primitives.count("B"))
        joined = (
            (match[1], int(match[2]), int(match[3])) for match in _matches(_PRIMITIVE, primitives)
        )
        return _join_outline(vertices, joined)

    def _check_count(self, count: int) -> None:
        if count > self._limits.segments:
            raise DrawingTooLarge(
                "reading.too-many-segments", format="LightBurn", limit=self._limits.segments
            )

    def rectangle(self, shape: ProjectShape) -> Shape:
        """Return the outline of a rectangle about the origin, whose corners may be round."""
        width, height = (_value(shape.attributes, key) / 2.0 for key in ("W", "H"))
        corner = _value(shape.attributes, "Cr", 0.0)
        radius = min(abs(corner), abs(width), abs(height))
        x, y = abs(width), abs(height)
        if radius == 0.0:
            return Shape(polylines=[[-x, -y, x, -y, x, y, -x, y, -x, -y]])
        u, v = x - radius, y - radius
        # A negative radius rounds the corners inwards.
        turn = _RISING if corner > 0.0 else 0.0
        corners = ((u, -y, x, -v), (x, v, u, y), (-u, y, -x, v), (-x, -v, -u, -y))
        return Shape(
            polylines=[
                [first[2], first[3], second[0], second[1]]
                for first, second in zip(corners, (*corners[1:], corners[0]), strict=True)
                if first[2:] != second[:2]
            ],
            arcs=[(*ends, radius, radius, 0.0, turn) for ends in corners],
        )

    def ellipse(self, shape: ProjectShape) -> Shape:
        """Return an ellipse about the origin."""
        x, y = (abs(_value(shape.attributes, key)) for key in ("Rx", "Ry"))
        if x == 0.0 or y == 0.0:
            raise InvalidContent("import.bad-radius", radius=0.0)
        return Shape(
            arcs=[
                (x, 0.0, -x, 0.0, x, y, 0.0, _RISING),
                (-x, 0.0, x, 0.0, x, y, 0.0, _RISING),
            ]
        )


_TYPES: Final[dict[str, Callable[[Outlines, ProjectShape], Shape]]] = {
    "Path": Outlines.path,
    "Rect": Outlines.rectangle,
    "Ellipse": Outlines.ellipse,
}


def _join_outline(vertices: Sequence[Vertex], primitives: Iterable[tuple[str, int, int]]) -> Shape:
    """Return the lines and curves between vertices.

    Each primitive is "L" or "B" and the indices of two vertices.  Lines that follow each other are
    one polyline.
    """
    shape = Shape()
    last = -1
    for kind, first, second in primitives:
        if max(first, second) >= len(vertices) or kind not in ("L", "B"):
            raise InvalidContent(
                "import.bad-primitive", kind=kind[:_MAX_SHOWN], first=first, second=second
            )
        start, end = vertices[first], vertices[second]
        if kind == "B":
            shape.curves.append((*start[:2], *end[:2], *start.leaving, *end.reaching))
            last = -1
        elif first == last:
            shape.polylines[-1] += end[:2]
            last = second
        else:
            shape.polylines.append([*start[:2], *end[:2]])
            last = second
    return shape


def _matches(pattern: re.Pattern[str], text: str) -> Iterable[re.Match[str]]:
    """Yield the matches of a pattern, which must cover the whole text.

    Raises ``InvalidContent``: a part of the text does not match.
    """
    position = 0
    while position < len(text):
        match = pattern.match(text, position)
        if match is None:
            if not text[position:].strip():
                return
            part = text[position : position + _MAX_SHOWN]
            raise InvalidContent("import.bad-path-data", character=position + 1, text=part)
        yield match
        position = match.end()


def _control(x: str | None, y: str | None, vertex_x: float, vertex_y: float) -> tuple[float, float]:
    """Return the control point that a packed vertex states, or the vertex itself."""
    if x is None or (y is None and float(x) == 1.0):
        return vertex_x, vertex_y
    return float(x), float(y or "0")


def _legacy_control(
    given: dict[str, str], name: str, vertex_x: float, vertex_y: float
) -> tuple[float, float]:
    """Return the control point of a vertex; the vertex itself if the file has none."""
    if f"{name}x" not in given or f"{name}y" not in given:
        return vertex_x, vertex_y
    return _value(given, f"{name}x"), _value(given, f"{name}y")


def _value(attributes: dict[str, str], name: str, default: float | None = None) -> float:
    """Return an attribute that is a number.

    Raises ``InvalidContent``: the attribute is missing and has no default, or is not a number.
    """
    text = attributes.get(name)
    if text is None:
        if default is None:
            raise InvalidContent("import.incomplete", part=name)
        return default
    if _ONE_NUMBER.fullmatch(text.strip()) is None or not math.isfinite(float(text)):
        reason = Message("import.value-not-numbers", value=text[:_MAX_SHOWN])
        raise InvalidContent("import.bad-size", name=name, reason=reason)
    return float(text)


def _index(attributes: dict[str, str], name: str) -> int:
    """Return an attribute that is the index of a vertex."""
    value = _value(attributes, name)
    if value < 0.0 or value != int(value):
        reason = Message("import.value-not-numbers", value=attributes[name][:_MAX_SHOWN])
        raise InvalidContent("import.bad-size", name=name, reason=reason)
    return int(value)


def parse_matrix(text: str | None) -> tuple[float, float, float, float, float, float]:
    """Return the matrix of a shape that the text ``XForm`` states.

    Raises
    ------
    InvalidContent
        The text is not six numbers.
    """
    if text is None:
        return 1.0, 0.0, 0.0, 1.0, 0.0, 0.0
    parts = text.split()
    if len(parts) != 6 or any(_ONE_NUMBER.fullmatch(part) is None for part in parts):
        raise InvalidContent("import.value-not-transform", value=text.strip()[:40])
    a, b, c, d, e, f = map(float, parts)
    return a, b, c, d, e, f
