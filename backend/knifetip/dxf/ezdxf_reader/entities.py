"""entities: convert ezdxf entities to plane shapes, with one function per kind of entity.

LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE become ``Lines``, ELLIPSE an ``Ellipse``, and SPLINE a
``Spline``.  Shapes are in the coordinates of model space, or of the block that contains the entity,
in file units.  An extrusion of −Z mirrors entities that are drawn in their own plane (ARC, CIRCLE,
polylines): their x axis points to the left.  Shapes parallel to the XY plane are projected onto it,
with a note.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import numpy as np

from knifetip.dxf.shapes import (
    arc_segment_count,
    mirror_segments,
    one_width,
    polyline_segment_count,
    sweep_angle,
    write_arc,
    write_polyline,
)
from knifetip.formats.limits import REACH
from knifetip.geometry.columns import F64
from knifetip.geometry.ellipse import Ellipse
from knifetip.geometry.spline import Spline
from knifetip.messages import Message

if TYPE_CHECKING:
    from ezdxf.entities.dxfgfx import DXFGraphic


@dataclass(frozen=True, eq=False, slots=True)
class Lines:
    """The shape of an entity as n segments: lines, and arcs of at most 180 degrees each.

    ``ends`` contains the start and the end point of each segment.  ``bulge`` contains the tangent
    of a quarter of the sweep angle of each arc, positive if the arc is counter-clockwise; it is 0
    for a line.
    """

    ends: F64  #: (n, 2, 2) file units
    bulge: F64  #: (n,)


Shape: TypeAlias = Lines | Ellipse | Spline


@dataclass(frozen=True, eq=False, slots=True)
class EntityShape:
    """The shape of an entity, notes on changes that were made to it, and its width.

    Only a polyline that is drawn as a wide line has a width as a part of its geometry.
    """

    shape: Shape
    notes: list[Message] = field(default_factory=list)
    line_width: float = 0.0  #: file units, 0 for none


class Undrawable(Exception):
    """Raised for an entity without geometry to cut.

    The attribute ``message`` is the reason that is added to the import report.
    """

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message  #: the reason in the import report


#: Heights that differ by less than this are equal (file units).
_FLAT: Final = 1e-6

#: Kinds without geometry to cut, and the reason in the import report.
_TEXT: Final = Message("import.text")
_NOTE: Final = Message("import.dimension")
_HATCH: Final = Message("import.hatch")
_AREA: Final = Message("import.filled-area")
_SOLID: Final = Message("import.solid")
_ENDLESS: Final = Message("import.endless-line")
_PICTURE: Final = Message("import.underlay")
REASONS: Final[dict[str, Message]] = {
    "TEXT": _TEXT,
    "MTEXT": _TEXT,
    "ATTRIB": _TEXT,
    "ATTDEF": _TEXT,
    "RTEXT": _TEXT,
    "ARCALIGNEDTEXT": _TEXT,
    "DIMENSION": _NOTE,
    "ARC_DIMENSION": _NOTE,
    "LARGE_RADIAL_DIMENSION": _NOTE,
    "LEADER": _NOTE,
    "MULTILEADER": _NOTE,
    "MLEADER": _NOTE,
    "TOLERANCE": _NOTE,
    "ACAD_TABLE": _NOTE,
    "HATCH": _HATCH,
    "MPOLYGON": _HATCH,
    "SOLID": _AREA,
    "TRACE": _AREA,
    "WIPEOUT": _AREA,
    "3DFACE": _SOLID,
    "3DSOLID": _SOLID,
    "BODY": _SOLID,
    "MESH": _SOLID,
    "SURFACE": _SOLID,
    "PLANESURFACE": _SOLID,
    "EXTRUDEDSURFACE": _SOLID,
    "LOFTEDSURFACE": _SOLID,
    "REVOLVEDSURFACE": _SOLID,
    "SWEPTSURFACE": _SOLID,
    "HELIX": Message("import.not-flat"),
    "REGION": Message("import.region"),
    "MLINE": Message("import.multiple-line"),
    "SHAPE": Message("import.font-shape"),
    "ACAD_PROXY_ENTITY": Message("import.proxy"),
    "RAY": _ENDLESS,
    "XLINE": _ENDLESS,
    "POINT": Message("import.point"),
    "IMAGE": _PICTURE,
    "OLEFRAME": _PICTURE,
    "OLE2FRAME": _PICTURE,
    "PDFUNDERLAY": _PICTURE,
    "DWFUNDERLAY": _PICTURE,
    "DGNUNDERLAY": _PICTURE,
    "VIEWPORT": Message("import.viewport"),
    "LIGHT": Message("import.light"),
    "VERTEX": Message("import.lone-vertex"),
    "SEQEND": Message("import.end-mark"),
}

#: Kinds that are never cut: texts, dimensions, construction lines, pictures, points and viewports.
NEVER_CUT: Final = frozenset(
    [
        *(kind for kind, reason in REASONS.items() if reason in (_TEXT, _NOTE, _ENDLESS, _PICTURE)),
        *("LIGHT", "POINT", "VIEWPORT"),
    ]
)


def shape_of(entity: DXFGraphic) -> EntityShape:
    """Return the shape of an ezdxf entity of a supported kind (a key of the table ``READ``).

    Raises
    ------
    Undrawable
        The entity has no geometry to cut.
    """
    return READ[entity.dxftype()](entity)


def height_notes(heights: Iterable[float]) -> list[Message]:
    """Check that a shape is parallel to the XY plane, and return the notes for the import report.

    ``heights`` are the z coordinates of the points of the shape (file units).  The list contains a
    note that the shape is projected onto the XY plane, or is empty if all z coordinates are 0.

    Raises
    ------
    Undrawable
        The z coordinates differ, or one of them is too large or not a finite number.
    """
    every = list(heights)
    low, high = min(every), max(every)
    if not (math.isfinite(low) and math.isfinite(high)):
        raise Undrawable(Message("import.height-not-a-number"))
    if max(abs(low), abs(high)) > REACH:
        height = max(low, high, key=abs)
        raise Undrawable(Message("import.height-too-far", height=height, limit=REACH))
    if high - low > _FLAT:
        raise Undrawable(Message("import.uneven-height", low=low, high=high))
    is_raised = max(abs(low), abs(high)) > _FLAT
    return [Message("import.laid-flat", height=low)] if is_raised else []


def is_mirrored(entity: DXFGraphic) -> bool:
    """Return whether an entity is mirrored by an extrusion of −Z.

    Raises
    ------
    Undrawable
        The extrusion is neither Z nor −Z: the entity lies in a tilted plane.
    """
    x, y, z = entity.dxf.get("extrusion", (0.0, 0.0, 1.0))
    size = math.sqrt(x * x + y * y + z * z)
    if not math.isfinite(size):
        raise Undrawable(Message("import.extrusion-not-a-number"))
    if size == 0.0:
        return False
    if math.hypot(x, y) > 1e-9 * size:
        tilt = math.degrees(math.atan2(math.hypot(x, y), z))
        raise Undrawable(Message("import.tilted", degrees=tilt))
    return bool(z < 0.0)


def _number(entity: DXFGraphic, name: str, word: str) -> Any:
    if not entity.dxf.hasattr(name):
        raise Undrawable(Message("import.incomplete", part=word))
    return entity.dxf.get(name)


def _line(entity: DXFGraphic) -> EntityShape:
    a = _number(entity, "start", "first end")
    b = _number(entity, "end", "second end")
    notes = height_notes((a.z, b.z))
    return EntityShape(Lines(np.array([[[a.x, a.y], [b.x, b.y]]]), np.zeros(1)), notes)


def _round(centre: Any, radius: float, first: float, sweep: float, mirror: bool) -> Lines:
    """Return an arc or a circle as segments of at most 180 degrees.

    ``centre``, ``radius``: centre, with attributes ``x`` and ``y``, and radius of the arc (file
    units).
    ``first``, ``sweep``: start angle and sweep (degrees).
    ``mirror``: whether the x coordinates are negated.
    """
    if not radius > 0.0:
        raise Undrawable(Message("import.bad-radius", radius=radius))
    rows = arc_segment_count(sweep)
    ends, bulge = np.empty((rows, 2, 2)), np.empty(rows)
    write_arc(float(centre.x), float(centre.y), float(radius), first, sweep, ends, bulge, 0)
    if mirror:
        mirror_segments(ends, bulge, 0, rows)
    return Lines(ends, bulge)


def _arc(entity: DXFGraphic) -> EntityShape:
    centre = _number(entity, "center", "centre")
    radius = _number(entity, "radius", "radius")
    first = _number(entity, "start_angle", "start angle")
    last = _number(entity, "end_angle", "end angle")
    if not (math.isfinite(first) and math.isfinite(last)):
        raise Undrawable(Message("import.angles-not-numbers"))
    if last == first:
        raise Undrawable(Message("import.no-sweep", degrees=first))
    sweep = sweep_angle(float(first), float(last))
    notes = height_notes((centre.z,))
    return EntityShape(_round(centre, radius, float(first), sweep, is_mirrored(entity)), notes)


def _circle(entity: DXFGraphic) -> EntityShape:
    centre = _number(entity, "center", "centre")
    radius = _number(entity, "radius", "radius")
    notes = height_notes((centre.z,))
    return EntityShape(_round(centre, radius, 0.0, 360.0, is_mirrored(entity)), notes)


def _chain(xy: F64, bulge: F64, closed: bool, mirror: bool) -> Lines:
    """Return the segments of a polyline; an arc of more than 180 degrees becomes two segments.

    ``xy`` (n, 2): vertices of the polyline.
    ``bulge`` (n,): bulge of the segment that starts at each vertex.
    ``closed``: whether the last vertex is connected to the first vertex.
    ``mirror``: whether the x coordinates are negated.
    """
    if len(xy) < 2:
        raise Undrawable(Message("import.few-vertices", vertices=len(xy)))
    vertex = np.column_stack([xy, bulge])
    rows = polyline_segment_count(vertex, 0, len(vertex), closed)
    ends, turns = np.empty((rows, 2, 2)), np.empty(rows)
    write_polyline(vertex, 0, len(vertex), closed, ends, turns, 0)
    if mirror:
        mirror_segments(ends, turns, 0, rows)
    return Lines(ends, turns)


def _lwpolyline(entity: Any) -> EntityShape:
    points = np.array(entity.lwpoints.values, dtype=np.float64).reshape(-1, 5)
    notes = height_notes((float(entity.dxf.get("elevation", 0.0)),))
    widths = points[:, 2:4]
    if not widths.any():
        widths = np.array([float(entity.dxf.get("const_width", 0.0))])
    return EntityShape(
        _chain(points[:, :2], points[:, 4], entity.closed, is_mirrored(entity)),
        notes,
        float(one_width(widths.min(), widths.max())),
    )


#: Flag of a vertex of a spline's control polygon, which is not on the curve.
_FRAME: Final = 16


def _polyline(entity: Any) -> EntityShape:
    if entity.is_polygon_mesh or entity.is_poly_face_mesh:
        raise Undrawable(Message("import.mesh"))
    vertices = [v for v in entity.vertices if not int(v.dxf.get("flags", 0)) & _FRAME]
    positions = [_number(v, "location", "place of a vertex") for v in vertices]
    if not positions:
        raise Undrawable(Message("import.few-vertices", vertices=0))
    xy = np.array([(p.x, p.y) for p in positions])
    bulge = np.array([float(v.dxf.get("bulge", 0.0)) for v in vertices])
    if entity.is_3d_polyline:
        notes = height_notes(p.z for p in positions)
        return EntityShape(_chain(xy, np.zeros(len(xy)), entity.is_closed, mirror=False), notes)
    # A 2D polyline has the height of its header; its vertices may or may not repeat it.
    notes = height_notes(
        (float(entity.dxf.elevation.z) if entity.dxf.hasattr("elevation") else 0.0,)
    )
    widths = np.array(
        [
            float(v.dxf.get(f"{end}_width", entity.dxf.get(f"default_{end}_width", 0.0)))
            for v in vertices
            for end in ("start", "end")
        ]
    )
    return EntityShape(
        _chain(xy, bulge, entity.is_closed, is_mirrored(entity)),
        notes,
        float(one_width(widths.min(), widths.max())),
    )


def _ellipse(entity: DXFGraphic) -> EntityShape:
    centre = _number(entity, "center", "centre")
    major = _number(entity, "major_axis", "major axis")
    ratio = _number(entity, "ratio", "ratio")
    first = float(entity.dxf.get("start_param", 0.0))
    last = float(entity.dxf.get("end_param", 2.0 * math.pi))
    if not (math.isfinite(first) and math.isfinite(last)):
        raise Undrawable(Message("import.parameters-not-numbers"))
    notes = height_notes((centre.z,))
    if abs(major.z) > _FLAT:
        raise Undrawable(Message("import.tilted-axis", rise=major.z))
    size = math.hypot(major.x, major.y)
    if not size > 0.0:
        raise Undrawable(Message("import.no-major-axis"))
    side = -1.0 if is_mirrored(entity) else 1.0
    sweep = (last - first) % (2.0 * math.pi)
    if sweep < 1e-12 or 2.0 * math.pi - sweep < 1e-12:
        if abs(last - first) < math.pi:
            raise Undrawable(Message("import.no-parameter-range", parameter=first))
        sweep = 2.0 * math.pi
    u = np.array([major.x, major.y])
    v = np.array([-major.y, major.x]) * (ratio * side)
    return EntityShape(Ellipse(np.array([centre.x, centre.y]), u, v, first, first + sweep), notes)


#: Most fit points of a spline: interpolation takes quadratic time and memory.
_MOST_FIT_POINTS: Final = 1000


def _spline(entity: Any) -> EntityShape:
    if not entity.control_point_count() and entity.fit_point_count() > _MOST_FIT_POINTS:
        raise Undrawable(
            Message(
                "import.too-many-fit-points",
                points=entity.fit_point_count(),
                limit=_MOST_FIT_POINTS,
            )
        )
    curve = entity.construction_tool()
    control = curve.control_points
    notes = height_notes(point.z for point in control)
    xy = np.array([(point.x, point.y) for point in control])
    weights = np.array(curve.weights() or np.ones(len(xy)), dtype=np.float64)
    if not entity.control_point_count():
        notes.append(Message("import.fit-points"))
    return EntityShape(
        Spline(xy, weights, np.array(curve.knots(), dtype=np.float64), curve.order - 1), notes
    )


#: Kinds with geometry, and the function that reads each.
READ: Final[dict[str, Callable[[Any], EntityShape]]] = {
    "LINE": _line,
    "ARC": _arc,
    "CIRCLE": _circle,
    "LWPOLYLINE": _lwpolyline,
    "POLYLINE": _polyline,
    "ELLIPSE": _ellipse,
    "SPLINE": _spline,
}
