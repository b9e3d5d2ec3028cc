"""Random contours, and distances of points from contours, by brute force."""

from __future__ import annotations

import numpy as np
import shapely

from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths


def random_contour(seed: int, *, is_open: bool = False) -> Paths:
    """Return one contour of lines and arcs round the origin, 15 to 100 mm from it.

    The contour does not cross itself.  It has a random direction.  An open contour lacks one edge.
    """
    random = np.random.default_rng(seed)
    while True:
        count = int(random.integers(4, 14))
        angle = np.sort(random.uniform(0.0, 2.0 * np.pi, count))
        start = random.uniform(15.0, 100.0, count)[:, None] * np.column_stack(
            [np.cos(angle), np.sin(angle)]
        )
        end = np.roll(start, -1, axis=0)
        bulge = np.where(random.random(count) < 0.4, random.uniform(-0.6, 0.6, count), 0.0)
        if np.hypot(*(end - start).T).min() < 0.5:
            continue
        ring = shapely.Polygon(arc.points_along(start, end, bulge, 257)[:, :-1].reshape(-1, 2))
        if ring.is_valid and ring.area > 100.0:
            break
    if is_open:
        start, end, bulge = start[:-1], end[:-1], bulge[:-1]
    if random.random() < 0.5:
        start, end, bulge = end[::-1], start[::-1], -bulge[::-1]
    return Paths(start, end, bulge, np.array([0, len(bulge)], np.int32))


def distance(points: F64, paths: Paths) -> F64:
    """Return the distance of each point from the nearest line or arc, by brute force."""
    best = np.full(len(points), np.inf)
    for a, b, bend in zip(paths.start, paths.end, paths.bulge, strict=True):
        ends = np.minimum(np.hypot(*(points - a).T), np.hypot(*(points - b).T))
        chord = b - a
        if abs(bend) < 1e-9:
            share = np.clip((points - a) @ chord / (chord @ chord), 0.0, 1.0)
            ends = np.hypot(*(points - a - share[:, None] * chord).T)
        else:
            normal = np.array([-chord[1], chord[0]])
            middle = (a + b) / 2 + normal * (1 - bend * bend) / (4 * bend)
            size = np.hypot(*(a - middle))
            # In the arc's sector the chord is between the point and the centre, or beyond both.
            spoke = points - middle
            turn = np.arctan2(*(a - middle)[::-1])
            angle = (np.arctan2(spoke[:, 1], spoke[:, 0]) - turn) * np.sign(bend) % (2 * np.pi)
            within = angle <= 4 * np.arctan(abs(bend))
            ends = np.where(within, np.abs(np.hypot(*spoke.T) - size), ends)
        best = np.minimum(best, ends)
    return best


def depth_in_band(points: F64, contour: Paths, side: int, reach: F64) -> F64:
    """Return how deep each point lies in the band beside a contour, (n,) mm; 0 outside.

    The band is the union of the lines from P to P + σ diag(a, b) n, for all points P of the contour
    with the left normal n; at corners n takes all directions between those of the two edges.

    Parameters
    ----------
    points : (n, 2) mm
        The points.
    contour
        One contour; its arcs are replaced by 128 chords each.
    side
        σ, +1 for the band left of the contour, -1 for right.
    reach : (2,) mm
        a, b.
    """
    flat = arc.points_along(contour.start, contour.end, contour.bulge, 129)
    rows = np.where(contour.bulge == 0.0, 128, 1)
    xy = np.concatenate([along[::step][:-1] for along, step in zip(flat, rows, strict=True)])
    xy = np.concatenate([xy, contour.end[-1:]])
    edge = np.diff(xy, axis=0)
    size = np.hypot(*edge.T)
    ahead = edge / size[:, None]
    normal = side * np.column_stack([-ahead[:, 1], ahead[:, 0]])
    across = normal * reach
    wide = (across * normal).sum(axis=1)
    last = np.roll(across, 1, axis=0)
    is_convex = side * (last[:, 0] * across[:, 1] - last[:, 1] * across[:, 0]) < 0.0
    if not contour.closed[0]:
        is_convex[0] = False
    depth = np.zeros(len(points))
    for i, point in enumerate(points):
        to = point - xy[:-1]
        part = (to * normal).sum(axis=1) / wide
        along = ((to - part[:, None] * across) * ahead).sum(axis=1)
        beside = (part > 1e-9) & (part < 1.0) & (along >= 0.0) & (along <= size)
        scaled = np.hypot(*(to / reach).T)
        before = side * (last[:, 0] * to[:, 1] - last[:, 1] * to[:, 0]) <= 0.0
        behind = side * (to[:, 0] * across[:, 1] - to[:, 1] * across[:, 0]) <= 0.0
        round_corner = is_convex & before & behind & (scaled > 1e-9) & (scaled < 1.0)
        depth[i] = max(
            np.where(beside, (1.0 - part) * wide, 0.0).max(),
            np.where(round_corner, (1.0 - scaled) * reach.min(), 0.0).max(),
        )
    return depth
