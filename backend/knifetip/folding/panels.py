"""panels: divide the blanks of a drawing into panels, and find the hinges between them.

Panels are the faces between cuts, creases, combi lines and V-grooves within a blank.  Draughtsmen
end creases before the cut that they run to; such an end is extended.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from knifetip.errors import DrawingTooLarge
from knifetip.folding.records import Hinge, Panel, Sheet
from knifetip.geometry.columns import F64, I64
from knifetip.layout.blanks import chord_lines, find_blanks
from knifetip.model.dieline import Dieline, LineType

#: Line types along which a blank folds.
FOLDING: Final = (LineType.CREASE, LineType.V_GROOVE, LineType.COMBI)
#: Most panels of a drawing, and most edges from which they are found.
MOST_PANELS: Final = 500
MOST_EDGES: Final = 50_000

#: Grid of the corners of panels (mm).
_GRID: Final = 0.001
#: Distance within which an end lies on another line (mm).
_TOUCH: Final = 0.002
#: Length by which an end that touches a line is extended across it (mm).
_ACROSS: Final = 0.005
#: Greatest length by which folds and cuts are extended to the next line (mm).
_FOLD_REACH: Final = 5.0
_CUT_REACH: Final = 1.0
#: Area of crumbs between lines that lie close to each other, which are no panels (mm²).
_CRUMB: Final = 1.0
#: Greatest distance of the lines of a straight hinge from its axis (mm).
_STRAIGHT: Final = 0.2
#: Least share of the lines of a straight hinge that must lie on its axis.
_SHARE: Final = 0.95

_Lines = NDArray[np.object_]


def find_panels(dieline: Dieline) -> Sheet:
    """Return the panels of a cleaned dieline, and the hinges between them.

    Raises
    ------
    DrawingTooLarge
        There are more than ``MOST_EDGES`` edges or ``MOST_PANELS`` panels.
    """
    made = np.isin(dieline.line_type, (LineType.CUT, *FOLDING))
    if made.sum() > MOST_EDGES:
        raise DrawingTooLarge("folding.too-many-edges", limit=MOST_EDGES)
    kinds = dieline.line_type[made]
    lines = chord_lines(dieline.ends[made], dieline.bulge[made])
    lines, source = _extended(lines, kinds == LineType.CUT)
    kinds = kinds[source]
    blanks = find_blanks(dieline)
    polygons, blank = _faces(lines, blanks)
    if len(polygons) > MOST_PANELS:
        raise DrawingTooLarge("folding.too-many-panels", limit=MOST_PANELS)
    sides, owner, ring = _sides(polygons)
    hinge_of, hinges = _hinges(sides, owner, _side_kinds(sides, lines, kinds))
    panels = [
        Panel(int(blank[k]), polygon, _by_ring(hinge_of[owner == k], ring[owner == k]))
        for k, polygon in enumerate(polygons)
    ]
    return Sheet(tuple(panels), tuple(hinges), _chords(lines[kinds == LineType.CUT]))


def _extended(lines: _Lines, cut: NDArray[np.bool_]) -> tuple[_Lines, I64]:
    """Return n lines and extensions of their free ends, (m,), and the source line of each, (m,)."""
    added: list[LineString] = []
    source = [*range(len(lines))]
    tree = shapely.STRtree(lines)
    ends = np.concatenate([_end_points(lines, 0, 1), _end_points(lines, -1, -2)])
    points = shapely.points(ends[:, 0])
    near, _ = shapely.STRtree(points).query(points, "dwithin", distance=_TOUCH)
    free = np.bincount(near, minlength=len(points)) == 1
    for k in np.flatnonzero(free).tolist():
        row = k % len(lines)
        end, before = ends[k]
        step = (end - before) / max(float(np.hypot(*(end - before))), 1e-12)
        reach = _ACROSS
        if (tree.query(points[k], "dwithin", distance=_TOUCH) == row).all():
            reach = _way_to_next(end, step, _CUT_REACH if cut[row] else _FOLD_REACH, lines, tree)
        added.append(LineString([end, end + reach * step]))
        source.append(row)
    return np.concatenate([lines, np.array(added, object)]), np.array(source, np.int64)


def _way_to_next(end: F64, step: F64, reach: float, lines: _Lines, tree: shapely.STRtree) -> float:
    """Return the distance to the next line in a direction, and a little more, or ``reach``."""
    ray = LineString([end + _TOUCH * step, end + reach * step])
    near = tree.query(ray, "intersects")
    if len(near) == 0:
        return reach
    hits = shapely.get_coordinates(shapely.intersection(lines[near], ray))
    return float(((hits - end) @ step).min()) + _ACROSS


def _end_points(lines: _Lines, at: int, beside: int) -> F64:
    """Return an end of each of n lines and the vertex beside it, (n, 2, 2)."""
    points = (shapely.get_point(lines, at), shapely.get_point(lines, beside))
    ends: F64 = np.stack([shapely.get_coordinates(one) for one in points], axis=1)
    return ends


def _faces(lines: _Lines, blanks: list[Polygon]) -> tuple[list[Polygon], I64]:
    """Return the faces between lines that lie in blanks, and the blank of each."""
    if not blanks:
        return [], np.zeros(0, np.int64)
    noded = shapely.union_all(lines, grid_size=_GRID)
    faces = shapely.get_parts(shapely.polygonize([*shapely.get_parts(noded)]))
    faces = shapely.orient_polygons(faces[shapely.area(faces) > _CRUMB])
    inner = shapely.point_on_surface(faces)
    face, blank = shapely.STRtree(blanks).query(inner, "within")
    return [*faces[face]], np.asarray(blank, np.int64)


def _sides(polygons: list[Polygon]) -> tuple[F64, I64, I64]:
    """Return the s sides of polygons, (s, 2, 2), with the polygon and the ring of each, (s,)."""
    sides, owner, ring = [np.zeros((0, 2, 2))], [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
    for k, polygon in enumerate(polygons):
        for number, line in enumerate((polygon.exterior, *polygon.interiors)):
            points = shapely.get_coordinates(line)
            sides.append(np.stack([points[:-1], points[1:]], axis=1))
            owner.append(np.full(len(points) - 1, k))
            ring.append(np.full(len(points) - 1, number))
    return np.concatenate(sides), np.concatenate(owner), np.concatenate(ring)


def _side_kinds(sides: F64, lines: _Lines, kinds: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the line type of each of s sides; cuts count where several lines lie on it."""
    found = np.full(len(sides), LineType.UNCLASSIFIED, np.uint8)
    if len(sides) == 0:
        return found
    middle = shapely.points(sides.mean(axis=1))
    side, line = shapely.STRtree(lines).query_nearest(middle, max_distance=10.0 * _GRID)
    cut = kinds[line] == LineType.CUT
    order = np.argsort(cut, kind="stable")  # cuts last, so that they remain
    found[side[order]] = kinds[line[order]]
    return found


def _hinges(sides: F64, owner: I64, kinds: NDArray[np.uint8]) -> tuple[I64, list[Hinge]]:
    """Return the hinge of each of s sides, -1 for none, and the hinges."""
    hinge_of = np.full(len(sides), -1, np.int64)
    hinges: list[Hinge] = []
    folding = np.flatnonzero(np.isin(kinds, FOLDING))
    corners = np.rint(sides[folding] / _GRID).astype(np.int64)
    swap = (corners[:, 0] > corners[:, 1]).any(axis=1) & (
        (corners[:, 0, 0] > corners[:, 1, 0])
        | ((corners[:, 0, 0] == corners[:, 1, 0]) & (corners[:, 0, 1] > corners[:, 1, 1]))
    )
    corners[swap] = corners[swap][:, ::-1]
    _, key = np.unique(corners.reshape(-1, 4), axis=0, return_inverse=True)
    order = np.argsort(key, kind="stable")
    key, folding = key[order], folding[order]
    first = np.flatnonzero(key[1:] == key[:-1])
    pairs: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for one, other in zip(folding[first].tolist(), folding[first + 1].tolist(), strict=True):
        if owner[one] == owner[other]:
            continue
        mine, theirs = (one, other) if owner[one] < owner[other] else (other, one)
        pairs.setdefault((int(owner[mine]), int(owner[theirs])), []).append((mine, theirs))
    for (panel, neighbour), shared in sorted(pairs.items()):
        rows = np.array(shared)
        hinge_of[rows] = len(hinges)
        hinges.append(_hinge((panel, neighbour), sides[rows[:, 0]], kinds[rows[:, 0]]))
    return hinge_of, hinges


def _hinge(panels: tuple[int, int], sides: F64, kinds: NDArray[np.uint8]) -> Hinge:
    """Return a hinge from its sides, (s, 2, 2), each with the first panel on the left."""
    along = sides[:, 1] - sides[:, 0]
    length = np.hypot(*along.T)
    share = np.bincount(kinds, weights=length)
    points = sides.reshape(-1, 2)
    for way in (_widest(points), along[length.argmax()]):
        way = way / np.hypot(*way)
        if along[length.argmax()] @ way < 0.0:
            way = -way
        across = np.array([-way[1], way[0]])
        offset = points @ across
        level = float(np.average(sides.mean(axis=1) @ across, weights=length))
        near = (np.abs(offset - level) <= _STRAIGHT).reshape(-1, 2).all(axis=1)
        if straight := bool(length[near].sum() >= _SHARE * length.sum()):
            break
    reach = points @ way
    # From the last point to the first: the first panel, which was on the left, is on the right.
    ends = np.outer([reach.max(), reach.min()], way) + level * across
    kind = LineType(int(share.argmax()))
    return Hinge(panels, kind, ends, float(length.sum()), straight)


def _widest(points: F64) -> F64:
    """Return the vector between two far points of a few: the farthest from the first two times."""
    one = points[np.hypot(*(points - points[0]).T).argmax()]
    other = points[np.hypot(*(points - one).T).argmax()]
    vector: F64 = one - other
    return vector


def _by_ring(values: I64, ring: I64) -> tuple[I64, ...]:
    return tuple(values[ring == number] for number in range(int(ring.max(initial=0)) + 1))


def _chords(lines: _Lines) -> F64:
    """Return the chords of lines, (c, 2, 2)."""
    points, line = shapely.get_coordinates(lines, return_index=True)
    inner = np.flatnonzero(line[1:] == line[:-1])
    return np.stack([points[inner], points[inner + 1]], axis=1)
