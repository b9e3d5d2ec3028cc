"""Compute distances between the path of a disc and points or edges, in closed form where possible.

If a cutter deflects by different amounts along X and Y, its disc becomes an ellipse.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from knifetip.verification.columns import F64, Bool
from knifetip.verification.curves.intervals import EPSILON


def spans_near_points(curve: F64, point: F64, limit: float | F64) -> tuple[F64, F64]:
    """Return the start and the end of the stretch of each of n curves near a point, (n,) mm each.

    The stretch is the part of the curve within ``limit`` of the point; its start and end are
    distances from the start of the curve.  If there is no such part, the returned start is greater
    than the end.  An arc of more than half a turn may have such a stretch at each of its ends; then
    only the stretch at the end nearer to the point is returned.

    Parameters
    ----------
    curve, point : (n, 6), (n, 2) mm
        Lines and arcs as rows of six numbers (see ``curves.curve``), and the point for each of
        them.
    limit : mm
        Greatest distance from the point; one for all, or one for each curve, (n,).
    """
    to = point - curve[:, 1:3]
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    foot = (to * curve[:, 3:5]).sum(axis=1)
    square = limit**2 - np.where(straight, (to**2).sum(axis=1) - foot**2, 0.0)
    distance = np.maximum(np.hypot(*to.T), EPSILON)
    cosine = (radius**2 + distance**2 - limit**2) / (2.0 * radius * distance)
    turn = np.arccos(np.clip(cosine, -1.0, 1.0)) * radius
    turned = curve[:, 0] * (np.arctan2(to[:, 1], to[:, 0]) - curve[:, 4])
    middle = 0.5 * curve[:, 5] / radius
    turned = ((turned - middle + np.pi) % (2.0 * np.pi) - np.pi + middle) * radius
    position = np.where(straight, foot, turned)
    half = np.where(straight, np.sqrt(np.maximum(square, 0.0)), turn)
    half = np.where(np.where(straight, square <= 0.0, cosine >= 1.0), -1.0, half)
    # All of the circle is within the distance.
    half = np.where(~straight & (cosine <= -1.0), np.inf, half)
    low = np.where(half < 0.0, 1.0, np.maximum(position - half, 0.0))
    return low, np.where(half < 0.0, 0.0, np.minimum(position + half, curve[:, 5]))


def nearest_candidates(curve: F64, along: F64, edge: F64, round_: bool) -> Iterator[F64]:
    """Yield arrays of positions, one on each of n curves, at which the curve may be nearest to its
    edge.

    Each array is (n,) mm from the start of the curve.  The curves are paths of the centre of a
    disc.

    Parameters
    ----------
    curve, edge : (n, 6)
        The curves, and the edge whose distance from each curve is sought: lines and arcs as rows of
        six numbers (see ``curves.curve``).
    along : (n, 2) mm
        Start and end of the stretch of each curve that is searched.
    round_
        True if the disc is a circle.  If it is an ellipse, more positions are yielded.
    """
    low, high = along.T
    yield low
    yield high
    straight, flat = curve[:, 0] == 0.0, edge[:, 0] == 0.0
    to = edge[:, 1:3] - curve[:, 1:3]
    foot = np.where(straight, (to * curve[:, 3:5]).sum(axis=1), 0.0)
    square = np.arctan2(edge[:, 3], -edge[:, 4])
    towards = np.where(flat, square, np.arctan2(to[:, 1], to[:, 0]))
    for half in (0.0, np.pi):
        turned = curve[:, 0] * (towards + half - curve[:, 4]) % (2.0 * np.pi)
        yield np.clip(np.where(straight, foot, turned * curve[:, 3]), low, high)
    # Where the curve crosses the circle of an arc.
    radius = np.where(flat, 1.0, edge[:, 3])
    for crossing in spans_near_points(curve, edge[:, 1:3], radius):
        yield np.where(flat, low, np.clip(crossing, low, high))
    if not round_:
        for fraction in np.linspace(0.0, 1.0, 9)[1:-1]:
            yield low + (high - low) * fraction


def nearest_along(curve: F64, point: F64, reach: F64) -> F64:
    """Return the position on each of n curves that is nearest to a point, (n,) mm.

    Parameters
    ----------
    curve, point : (n, 6), (n, 2) mm
        Lines and arcs as rows of six numbers (see ``curves.curve``), and the point for each of
        them.
    reach : (2,) mm
        Half-axes along X and Y of the disc whose centre follows the curves.  For a line, distances
        along X and along Y are divided by these half-axes; for an arc, they are taken in mm.
    """
    weight = 1.0 / reach**2
    to = point - curve[:, 1:3]
    straight = curve[:, 0] == 0.0
    u = curve[:, 3:5]
    line = (weight * to * u).sum(axis=1) / np.where(
        straight, np.maximum((weight * u * u).sum(axis=1), EPSILON), 1.0
    )
    turned = curve[:, 0] * (np.arctan2(to[:, 1], to[:, 0]) - curve[:, 4])
    middle = 0.5 * curve[:, 5] / np.where(straight, 1.0, curve[:, 3])
    turned = (turned - middle + np.pi) % (2.0 * np.pi) - np.pi + middle
    position = np.where(straight, line, turned * curve[:, 3])
    result: F64 = np.clip(position, 0.0, curve[:, 5])
    return result


def _angle_beside_arc(angle: F64, arcs: F64) -> F64:
    """Return the angle between a direction and the nearest radius of each of n arcs, (n,) rad.

    The result is 0 for a direction, as seen from the arc's centre, in which the arc lies.
    ``angle`` (n,) are the directions (rad), and ``arcs`` (n, 6) rows as in ``curves.curve``.
    """
    past = np.mod(arcs[:, 0] * (angle - arcs[:, 4]), 2.0 * np.pi)
    sweep = arcs[:, 5] / arcs[:, 3]
    result: F64 = np.where(past <= sweep, 0.0, np.minimum(past - sweep, 2.0 * np.pi - past))
    return result


def is_beside_arc(points: F64, edge: F64, reach: F64) -> Bool:
    """Return whether each of n points lies in the sector of its arc, seen from the centre, (n,).

    The result is True for lines, and at the centre itself.  For an elliptic disc the sector is
    widened by the greatest angle between the direction of a point from the centre and the direction
    of the point at which the disc touches the arc.

    Parameters
    ----------
    points, edge : (n, 2) mm and (n, 6)
        The points, and the edge for each of them: a line or arc as a row of six numbers (see
        ``curves.curve``).
    reach : (2,) mm
        Half-axes of the disc along X and Y.
    """
    result: Bool = edge[:, 0] == 0.0
    bent = np.flatnonzero(~result)
    to = points[bent] - edge[bent, 1:3]
    beside = _angle_beside_arc(np.arctan2(to[:, 1], to[:, 0]), edge[bent])
    past = np.hypot(*to.T) * np.minimum(beside, 0.5 * np.pi)
    result[bent] = past <= 2.0 * np.ptp(reach) + EPSILON
    return result


def disc_penetration(points: F64, edge: F64, reach: F64) -> F64:
    """Return how far a disc or ellipse centred at each of n points extends past an edge, (n,) mm.

    The result is negative if the disc does not reach the edge, and -∞ for a point that does not lie
    beside an arc: the ends of the arc are nearest to it, which are corners.

    Parameters
    ----------
    points, edge : (n, 2) mm and (n, 6)
        Centres of the disc, and the edge for each of them: a line or arc as a row of six numbers
        (see ``curves.curve``).
    reach : (2,) mm
        Half-axes of the disc along X and Y.
    """
    to = points - edge[:, 1:3]
    straight = edge[:, 0] == 0.0
    normal = np.where(straight[:, None], edge[:, [4, 3]] * (-1.0, 1.0), 0.0)
    line_distance = np.abs((normal * to).sum(axis=1))
    flat = (normal**2 * reach).sum(axis=1) - line_distance
    # Beside an arc the path of the centre is an ellipse with these half-axes.
    distance = np.hypot(*to.T)
    outer = distance >= edge[:, 3]
    axes = edge[:, 3, None] + np.where(outer, 1.0, -1.0)[:, None] * reach
    scaled = np.hypot(*(to / np.where(np.abs(axes) > EPSILON, axes, EPSILON)).T)
    size = np.abs(axes).min(axis=1)
    bent = np.where(outer, 1.0 - scaled, scaled - 1.0) * size
    # Where the circle of the arc is smaller than the disc, the disc extends past the arc by most
    # along the radius that is nearest in direction to the disc's centre.
    narrow = np.flatnonzero(~outer & (axes <= EPSILON).any(axis=1) & ~straight)
    beside = _angle_beside_arc(np.arctan2(to[narrow, 1], to[narrow, 0]), edge[narrow])
    across = np.sqrt(np.maximum(reach.max() ** 2 - (distance[narrow] * np.sin(beside)) ** 2, 0.0))
    bent[narrow] = distance[narrow] * np.cos(beside) + across - edge[narrow, 3]
    elsewhere = ~is_beside_arc(points, edge, reach)
    elsewhere[narrow] = False
    bent[elsewhere] = -np.inf
    result: F64 = np.where(straight, flat, bent)
    return result
