"""filled_outlines: find filled areas without a stroke whose contours are outlines of blanks.

Files of craft cutters contain a blank as a filled shape, with its folds as lines on top.  Most
filled areas beside lines are artwork instead.  An area is an outline if lines lie on it, and no
closed contour of lines is as large as the area: the lines alone then have no outline.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.drawing_builder.filled_region import filled_region
from knifetip.drawing_builder.path_table import ARC, CUBIC, LINE, Table, transform_points
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.union_find import component_roots
from knifetip.geometry.unique_rows import unique_rows

#: Number of areas that are examined: the largest ones.
_AREAS: Final = 200
#: Number of lines on an area whose positions are compared with it.
_SAMPLE: Final = 64
#: Distance within which ends of lines are connected, as a fraction of the size of all lines: an
#: outline with small gaps is an outline.
_NEAR: Final = 2e-3
#: Largest number of rounds in which open lines are removed, to find closed contours.
_ROUNDS: Final = 200
#: Distance by which a contour of the same size as an area may differ, as a fraction of its size.
_SAME: Final = 0.02
#: Distance by which lines may exceed the area on which they lie, as a fraction of its size.
_BEYOND: Final = 0.005
#: Distance within which the ends of a subpath are one point, as a fraction of its coordinates.
_POINT: Final = 1e-9
#: Shifts of the grid to which ends are rounded, in cells: near ends share a cell of one grid.
_SHIFTS: Final = ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5))


class FilledPaths(NamedTuple):
    """The p paths of a drawing, some of which are lines and some filled areas without a stroke."""

    table: Table  #: segments of the paths
    matrix: F64  #: (p, 6) matrix of each path to file units
    box: F64  #: (p, 4) bounding box of each path (file units)
    is_line: Bool  #: (p,) whether the path is drawn with a stroke
    is_area: Bool  #: (p,) whether the path is a visible area without a stroke


def find_filled_outlines(paths: FilledPaths) -> Bool:
    """Return the mask of the areas whose contours are outlines of blanks, (p,)."""
    found = np.zeros(len(paths.box), np.bool_)
    areas = np.flatnonzero(paths.is_area)
    lines = np.flatnonzero(paths.is_line & np.isfinite(paths.box).all(axis=1))
    if not (len(areas) and len(lines)):
        return found
    contours, blanks = _closed_contours(paths, lines), np.empty((0, 4))
    for area in _largest_first(paths, areas)[:_AREAS].tolist():
        edges = _contour(paths, area)
        if not len(edges) or not np.isfinite(edges).all():
            continue
        corners = edges.reshape(-1, 2)
        box = np.concatenate([corners.min(axis=0), corners.max(axis=0)])
        size = box[2:] - box[:2]
        # A shape on a blank is artwork, or a second layer of colour.
        if _covers(contours, box, _SAME * size).any() or _covers(blanks, box, _BEYOND * size).any():
            continue
        inside = _covers(box[None], paths.box[lines].T, _BEYOND * size[:, None])
        if inside.any() and _is_blank(edges, box, paths.box[lines[inside]]):
            found[area] = True
            blanks = np.concatenate([blanks, box[None]])
    return found


def close_subpaths(table: Table, areas: Bool) -> Table:
    """Return segments of p paths with lines that close the open subpaths of areas.

    A fill closes a subpath, whether the file does or not.  ``areas`` (p,) is the mask of the paths
    that are areas.
    """
    ends, path = table.numbers[:, :4], table.path
    if not len(path):
        return table
    begins = np.append(True, (ends[1:, :2] != ends[:-1, 2:]).any(axis=1) | (np.diff(path) > 0))
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(path)) - 1
    gap = np.abs(ends[last, 2:] - ends[first, :2]).max(axis=1)
    is_open = areas[path[first]] & (gap > _POINT * np.abs(ends[first]).max(axis=1))
    first, last = first[is_open], last[is_open]
    closing = np.zeros((len(first), table.numbers.shape[1]))
    closing[:, :2], closing[:, 2:4] = ends[last, 2:], ends[first, :2]
    return Table(
        np.insert(table.kind, last + 1, LINE),
        np.insert(table.numbers, last + 1, closing, axis=0),
        np.insert(path, last + 1, path[last]),
    )


def _largest_first(paths: FilledPaths, areas: I64) -> I64:
    """Return the indices of areas in descending order of their approximate sizes."""
    box, reach = paths.box[areas], np.zeros(len(paths.box))
    np.maximum.at(reach, paths.table.path, _arc_reach(paths.table, paths.matrix[paths.table.path]))
    size = (box[:, 2:] - box[:, :2]).max(axis=1) + reach[areas]
    return areas[np.argsort(-np.nan_to_num(size), kind="stable")]


def _contour(paths: FilledPaths, area: int) -> F64:
    """Return the edges of the contour of an area, (m, 2, 2) (file units)."""
    rows = slice(*np.searchsorted(paths.table.path, [area, area + 1]).tolist())
    part = Table(paths.table.kind[rows], paths.table.numbers[rows], paths.table.path[rows])
    a, b, c, d, e, f = paths.matrix[area].tolist()
    return filled_region(part, (a, b, c, d, e, f), even_odd=True).edges


def _arc_reach(table: Table, matrices: F64) -> F64:
    """Return an upper bound of the distance of arcs from the box of their ends, (n,).

    It is 0 for other segments.  ``matrices`` (n, 6) are the matrices of the n segments.
    """
    radius = table.numbers[:, 4:6].max(axis=1, initial=0.0)
    scale = np.abs(matrices[:, :4]).max(axis=1)
    bound: F64 = np.where(table.kind == ARC, 2.0 * radius * scale, 0.0)
    return bound


def _covers(outer: F64, inner: F64, margin: F64) -> Bool:
    """Return the mask of boxes that contain others, except for a margin.

    ``outer``, ``inner`` (k, 4) and (4,), or (1, 4) and (4, k): boxes of which one of each pair may
    contain the other.
    ``margin`` (2,) or (2, 1): distance in x and in y by which the inner box may exceed the outer
    box.
    """
    low = [outer[:, k] <= inner[k] + margin[k] for k in range(2)]
    high = [outer[:, k + 2] >= inner[k + 2] - margin[k] for k in range(2)]
    mask: Bool = np.logical_and.reduce(low + high)
    return mask


def _is_blank(edges: F64, box: F64, lines: F64) -> bool:
    """Return whether most of the lines in the box of an area lie on the area itself.

    The lines on a rectangle must also extend between two opposite sides and no others: a rectangle
    with lines at a distance from its sides, or with lines at all sides, is a background.

    ``edges``, ``box`` (m, 2, 2) and (4,): edges of the contour of the area, and its bounding box.
    ``lines`` (k, 4): bounding boxes of the lines.
    """
    margin = _SAME * (box[2:] - box[:2])
    corners = edges.reshape(-1, 2)
    is_rectangle = ((corners == box[:2]) | (corners == box[2:])).all()
    if is_rectangle:
        low, high = lines[:, :2].min(axis=0), lines[:, 2:].max(axis=0)
        if np.count_nonzero((low <= box[:2] + margin) & (high >= box[2:] - margin)) != 1:
            return False
    sample = lines[:: len(lines) // _SAMPLE + 1]
    middle = 0.5 * (sample[:, :2] + sample[:, 2:])
    return bool(np.count_nonzero(_inside(middle, edges)) > 0.5 * len(sample))


def _inside(points: F64, edges: F64) -> Bool:
    """Return the mask of k points, (k, 2), that are inside a contour of edges, (m, 2, 2)."""
    x, y = points[:, :1], points[:, 1:]
    (x0, y0), (x1, y1) = edges[:, 0].T, edges[:, 1].T
    crosses = (y0 > y) != (y1 > y)
    with np.errstate(all="ignore"):
        at = x0 + (y - y0) * (x1 - x0) / (y1 - y0)
    odd: Bool = np.count_nonzero(crosses & (x < at), axis=1) % 2 == 1
    return odd


def _closed_contours(paths: FilledPaths, lines: I64) -> F64:
    """Return the boxes of connected closed contours of lines, (k, 4) (file units).

    Lines with a free end close no contour.  ``lines`` are indices of paths.
    """
    is_line = np.zeros(len(paths.box), np.bool_)
    is_line[lines] = True
    rows = is_line[paths.table.path]
    table = Table(paths.table.kind[rows], paths.table.numbers[rows], paths.table.path[rows])
    matrix = paths.matrix[table.path]
    points = [transform_points(matrix, table.numbers[:, k : k + 2]) for k in (0, 2, 4, 6)]
    # Only curves have inner control points.
    points[2:] = [np.where((table.kind == CUBIC)[:, None], one, points[0]) for one in points[2:]]
    reach = _arc_reach(table, matrix)[:, None]
    low, high = np.min(points, axis=0) - reach, np.max(points, axis=0) + reach
    ends = np.concatenate(points[:2])
    vertex = _vertices(ends, _NEAR * np.ptp(ends, axis=0).max() or 1.0)
    left, right = np.split(vertex, 2)
    kept = np.arange(len(left))
    for _ in range(_ROUNDS):
        count = np.bincount(np.concatenate([left[kept], right[kept]]), minlength=len(vertex))
        closed = (count[left[kept]] > 1) & (count[right[kept]] > 1)
        if closed.all():
            break
        kept = kept[closed]
    pairs = np.stack([left[kept], right[kept]], axis=1).reshape(-1)
    _, contour = unique_rows(component_roots(pairs, len(vertex))[left[kept]])
    box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (int(contour.max(initial=-1)) + 1, 1))
    np.minimum.at(box[:, :2], contour, low[kept])
    np.maximum.at(box[:, 2:], contour, high[kept])
    return box


def _vertices(points: F64, near: float) -> I64:
    """Return for each of m points the number of its vertex, (m,); near points have the same."""
    pairs = []
    for shift in _SHIFTS:
        first, cell = unique_rows(np.floor(points / near + shift).astype(np.int64))
        pairs.append(np.stack([first[cell], np.arange(len(points))], axis=1))
    roots: I64 = component_roots(np.concatenate(pairs).reshape(-1), len(points))
    return roots
