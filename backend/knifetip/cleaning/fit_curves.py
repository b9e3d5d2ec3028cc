"""fit_curves: fit lines, arcs and circles to runs of chords.

Many programs write a curve as a polyline: a run of chords whose vertices lie on the curve.  A run
is *smooth* where each of its joints turns by at most ``SMOOTH_TURN`` (20°; more between very short
chords) and the chords are short enough for their turn: where a run turns by θ at each joint, a
chord of length l lies l θ / 8 inside the curve.  A regular polygon with large sides is therefore no
smooth run.

The distance of a run from the arc that replaces it is measured at every vertex, and at the point of
every chord that is nearest to the centre, where the chord is farthest inside the arc.  So the
greatest distance is exact, and no point of the drawing moves by more.
"""

from __future__ import annotations

import math
from typing import Final

from knifetip.geometry.tolerance import BULGE, GAP
from knifetip.kernels import F64_1, F64_2, Bool_1, OutF64_2, OutI64_1, inline_kernel, kernel

#: Least number of chords that are replaced by an arc.
FEW_CHORDS: Final = 4
#: Segments shorter than this belong to a flattened curve (mm).
FINE: Final = GAP
#: Least number of edges shorter than ``FINE`` that are replaced by a line or an arc.
FEW_FINE: Final = 3
#: Between two segments shorter than this, a turn is smooth if the joint lies within twice the
#: tolerance of the line from end to end (mm): rounded vertices make such turns.
SHORT: Final = 5.0 * FINE
#: Number of longer arcs that are tried after the first one that does not fit, if the vertices are
#: rounded.
_FARTHER: Final = 32
#: Least number of chords of a circle.
_CIRCLE_CHORDS: Final = 8
#: Tangent of the greatest turn at a joint of a smooth run (20°).
SMOOTH_TURN: Final = math.tan(math.radians(20.0))
#: The sagitta of a chord is estimated from the turns at its ends; it is measured later.
_ESTIMATE: Final = 1.5
#: A smaller bulge is fitted as a line.
_SHALLOW: Final = 1e-7
#: Two vertices are opposite each other on a circle up to this fraction of its radius.
_OPPOSITE: Final = 1e-7


@kernel(allocates=False)
def mark_smooth(
    run: F64_2,
    size: F64_1,
    stays: Bool_1,
    count: int,
    tolerance: float,
    fine: float,
    until: OutI64_1,
) -> bool:
    """Write for each segment of a run the index after the last segment of its smooth run.

    Returns whether the joint from the last segment to the first is smooth too.

    Parameters
    ----------
    run : (k, 5)
        Segments in order: x0, y0, x1, y1, bulge; only the first ``count`` rows are used.
    size : (k,)
        Lengths of the segments (mm).
    stays : (k,)
        Mask of the segments that belong to no smooth run.
    tolerance
        Greatest distance of a chord from an arc that replaces it (mm).
    fine
        Between two segments shorter than this, any turn is smooth (mm).
    until : (k,)
        Result.
    """
    until[count - 1] = count
    for i in range(count - 2, -1, -1):
        is_smooth = _is_smooth(run, size, stays, i, i + 1, tolerance, fine)
        until[i] = until[i + 1] if is_smooth else i + 1
    return _is_smooth(run, size, stays, count - 1, 0, tolerance, fine)


@inline_kernel
def _is_smooth(
    run: F64_2,
    size: F64_1,
    stays: Bool_1,
    segment_a: int,
    segment_b: int,
    tolerance: float,
    fine: float,
) -> bool:
    """Return whether the joint between two segments may lie inside a smooth run."""
    if stays[segment_a] or stays[segment_b]:
        return False
    both = size[segment_a] < fine and size[segment_b] < fine
    for segment in (segment_a, segment_b):
        if abs(run[segment, 4]) >= BULGE and size[segment] >= fine:
            return False
    if both:
        return True
    short = max(size[segment_a], size[segment_b]) < SHORT
    ax, ay = run[segment_a, 2] - run[segment_a, 0], run[segment_a, 3] - run[segment_a, 1]
    bx, by = run[segment_b, 2] - run[segment_b, 0], run[segment_b, 3] - run[segment_b, 1]
    along, across = ax * bx + ay * by, abs(ax * by - ay * bx)
    if along <= 0.0:
        return False
    if short and across <= 2.0 * tolerance * math.hypot(ax + bx, ay + by):
        return True
    if across > SMOOTH_TURN * along:
        return False
    return bool(
        across * min(size[segment_a], size[segment_b]) <= 8.0 * _ESTIMATE * tolerance * along
    )


@kernel(allocates=False)
def longest_line(run: F64_2, i: int, limit: int, tolerance: float) -> int:
    """Fit the longest line that starts where segment ``i`` of ``run`` starts.

    All joints between the replaced segments are within ``tolerance`` mm of the line.  Segments from
    index ``limit`` on are not replaced.  Returns the index of the first segment that is not
    replaced.
    """
    x, y = run[i, 0], run[i, 1]
    low, high = -math.inf, math.inf
    base = math.atan2(run[i, 3] - y, run[i, 2] - x)
    reached = 0.0
    end = i
    best = i + 1
    while end < limit and abs(run[end, 4]) < BULGE:
        dx, dy = run[end, 2] - x, run[end, 3] - y
        far = math.hypot(dx, dy)
        if far <= reached:
            break
        way = math.atan2(dy, dx) - base
        way = (way + math.pi) % (2.0 * math.pi) - math.pi
        if abs(way) > 0.5 * math.pi:
            break
        end += 1
        if low <= way <= high:
            best = end
        slack = math.asin(tolerance / far) if far > tolerance else math.pi
        low = max(low, way - slack)
        high = min(high, way + slack)
        if low > high:
            break
        reached = far
    return best


@kernel(allocates=False)
def longest_arc(
    run: F64_2, along: F64_1, i: int, limit: int, tolerance: float, rough: bool
) -> tuple[int, float, float]:
    """Fit the longest arc that starts where segment ``i`` of ``run`` starts.

    The replaced segments are within ``tolerance`` mm of the arc.  Segments from index ``limit`` on
    are not replaced.  The number of replaced segments is found by doubling and bisection, so the
    time is proportional to it, but for a logarithm.

    Parameters
    ----------
    run : (k, 5)
        Segments in order: x0, y0, x1, y1, bulge.
    along : (k + 1,)
        Length of the run before each segment (mm).
    rough
        Whether the vertices lie beside the curve, so that an arc that ends at one of them may fit
        although another one that is shorter does not.

    Returns
    -------
    end, bulge, distance
        Index of the first segment that is not replaced, bulge of the arc, and greatest distance of
        the replaced segments from it (mm).  If no arc fits, the index is ``i``.
    """
    good, code, off = i, 0.0, 0.0
    step = FEW_CHORDS
    bad = limit + 1
    while True:
        end = min(i + step, limit)
        b, far = fit_arc(run, along, i, end, tolerance, rough)
        if far <= tolerance:
            good, code, off = end, b, far
            if end == limit:
                return good, code, off
            step *= 2
        else:
            bad = end
            break
    low = good if good > i else i + 2
    while bad - low > 1:
        end = (low + bad) // 2
        b, far = fit_arc(run, along, i, end, tolerance, rough)
        if far <= tolerance:
            low, good, code, off = end, end, b, far
        else:
            bad = end
    if rough:
        for end in range(bad + 1, min(bad + _FARTHER, limit) + 1):
            b, far = fit_arc(run, along, i, end, tolerance, rough)
            if far <= tolerance:
                good, code, off = end, b, far
    return good, code, off


@kernel(allocates=False)
def fit_arc(
    run: F64_2, along: F64_1, i: int, end: int, tolerance: float, rough: bool
) -> tuple[float, float]:
    """Return the bulge of the arc that replaces segments ``i`` … ``end - 1`` of ``run``, and their
    greatest distance from it (mm), which is infinite if it exceeds ``tolerance``.

    The arc passes through the start of the first segment, the end of the last segment, and the
    joint near the middle of their length.  If it is too far and the vertices are ``rough``, it is
    the arc through both ends that is nearest to all joints.  ``along`` is the length of the run
    before each segment.
    """
    bulge = _bulge_through_middle(run, along, i, end)
    far = math.inf
    if bulge != 0.0:
        far = _distance_from_arc(run, i, end, bulge, tolerance)
    if rough and far > tolerance:
        bulge = _nearest_bulge(run, i, end)
        if bulge != 0.0:
            far = _distance_from_arc(run, i, end, bulge, tolerance)
    return bulge, far


@kernel(allocates=False)
def _bulge_through_middle(run: F64_2, along: F64_1, i: int, end: int) -> float:
    """Return the bulge of the arc through both ends of some segments and the joint near the middle
    of their length, as for ``fit_arc``; 0 if it is a line or more than half a circle.
    """
    middle = 0.5 * (along[i] + along[end])
    low, high = i, end - 1
    while high - low > 1:
        at = (low + high) // 2
        if along[at] <= middle:
            low = at
        else:
            high = at
    px, py = run[low, 2], run[low, 3]
    ax, ay = run[i, 0] - px, run[i, 1] - py
    bx, by = run[end - 1, 2] - px, run[end - 1, 3] - py
    # The inscribed angle at the joint is π minus half the sweep.
    angle = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    bulge = math.tan(0.5 * (math.pi - abs(angle)))
    if bulge > 1.0 + 1e-9 or bulge < _SHALLOW:
        return 0.0
    bulge = min(bulge, 1.0)
    return -bulge if angle > 0.0 else bulge


@kernel(allocates=False)
def _nearest_bulge(run: F64_2, i: int, end: int) -> float:
    """Return the bulge of the arc through both ends of segments ``i`` … ``end - 1`` that is nearest
    to their joints; 0 if it is a line or more than half a circle.

    With the chord from (-a, 0) to (a, 0), a circle through both ends has its centre at (0, h), and
    u² + v² - a² = 2hv holds for each point (u, v) of it.  h is the least-squares solution.
    """
    x0, y0 = run[i, 0], run[i, 1]
    dx, dy = run[end - 1, 2] - x0, run[end - 1, 3] - y0
    chord = math.hypot(dx, dy)
    if chord == 0.0:
        return 0.0
    half = 0.5 * chord
    squares = moments = rise = 0.0
    for s in range(i, end - 1):
        x, y = run[s, 2] - x0, run[s, 3] - y0
        u, v = (x * dx + y * dy) / chord - half, (y * dx - x * dy) / chord
        squares += v * v
        moments += v * (u * u + v * v - half * half)
        rise += v
    if rise == 0.0 or squares == 0.0:
        return 0.0
    # An arc that bulges to the right of its chord turns to the left.
    height = 0.5 * moments / squares
    side = 1.0 if rise < 0.0 else -1.0
    bulge = (math.hypot(height, half) - side * height) / half
    return side * bulge if _SHALLOW <= bulge <= 1.0 + 1e-9 else 0.0


@kernel(allocates=False)
def _distance_from_arc(run: F64_2, i: int, end: int, bulge: float, tolerance: float) -> float:
    """Return the greatest distance (mm) of some segments from the arc that replaces them.

    The segments are ``run[i]`` … ``run[end - 1]``.  The arc has the bulge ``bulge``, at most 1, and
    connects the start of the first segment to the end of the last segment.  The distance is
    infinite if it exceeds ``tolerance``, or if the segments do not follow the arc from its start to
    its end.
    """
    x0, y0 = run[i, 0], run[i, 1]
    dx, dy = run[end - 1, 2] - x0, run[end - 1, 3] - y0
    chord = math.hypot(dx, dy)
    if chord == 0.0:
        return math.inf
    lean = (1.0 - bulge * bulge) / (4.0 * bulge)
    cx, cy = x0 + 0.5 * dx - lean * dy, y0 + 0.5 * dy + lean * dx
    radius = chord * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
    sense = 1.0 if bulge > 0.0 else -1.0
    worst = 0.0
    px, py = x0 - cx, y0 - cy
    for s in range(i, end):
        ax, ay = run[s, 0] - cx, run[s, 1] - cy
        bx, by = run[s, 2] - cx, run[s, 3] - cy
        # The arc is on one side of its chord, and the segments go round the centre.
        beyond = sense * (dx * (run[s, 3] - y0) - dy * (run[s, 2] - x0))
        if sense * (px * by - py * bx) <= 0.0 or beyond > tolerance * chord:
            return math.inf
        off = _distance_of_segment(run, s, ax, ay, bx, by, radius)
        if s < end - 1:
            off = max(off, abs(math.hypot(bx, by) - radius))
        if ax != px or ay != py:
            # Ends that meet may be a little apart.
            off = max(off, abs(math.hypot(ax, ay) - radius))
        if off > tolerance:
            return math.inf
        worst = max(worst, off)
        px, py = bx, by
    return worst


@kernel(allocates=False)
def _distance_of_segment(
    run: F64_2, s: int, ax: float, ay: float, bx: float, by: float, radius: float
) -> float:
    """Return the distance (mm) of the inside of segment ``s`` from a circle round the origin.

    A line is measured where it is nearest to the centre.  (ax, ay) and (bx, by) are the start and
    end of the segment relative to the centre.
    """
    dx, dy, b = bx - ax, by - ay, run[s, 4]
    if abs(b) >= BULGE:
        return _distance_of_arc(0.5 * (ax + bx), 0.5 * (ay + by), dx, dy, b, radius)
    square = dx * dx + dy * dy
    foot = -(ax * dx + ay * dy)
    if 0.0 < foot < square:
        return abs(abs(ax * by - ay * bx) / math.sqrt(square) - radius)
    return 0.0


@kernel(allocates=False)
def _distance_of_arc(mx: float, my: float, dx: float, dy: float, b: float, radius: float) -> float:
    """Return the greatest distance (mm) of the inside of an arc from a circle round the origin.

    The arc has the bulge ``b``, and its chord the middle (mx, my) and the vector (dx, dy).  An arc
    is farthest from a circle at its ends, at its middle if both have one centre, or on the line
    through both centres.
    """
    x, y = mx + 0.5 * b * dy, my - 0.5 * b * dx
    worst = abs(math.hypot(x, y) - radius)
    lean = (1.0 - b * b) / (4.0 * b)
    cx, cy = mx - lean * dy, my + lean * dx
    own = math.hypot(dx, dy) * (1.0 + b * b) / (4.0 * abs(b))
    apart = math.hypot(cx, cy)
    if apart == 0.0:
        return worst
    cosine = (1.0 - b * b) / (1.0 + b * b)
    for side in (-1.0, 1.0):
        ux, uy = side * cx / apart, side * cy / apart
        # The direction lies in the sector of the arc.
        if ux * (x - cx) + uy * (y - cy) >= cosine * own:
            worst = max(worst, abs(math.hypot(cx + own * ux, cy + own * uy) - radius))
    return worst


@kernel(allocates=False)
def greatest_distance(run: F64_2, i: int, end: int, bulge: float) -> float:
    """Return the greatest distance (mm) of some segments from the line or arc that replaces them.

    The segments are ``run[i]`` … ``run[end - 1]``.  The line or arc has the bulge ``bulge``, and
    connects the start of the first segment to the end of the last segment.  The distance is
    infinite if the segments do not follow each other along the line or arc, or if the start and
    the end coincide.
    """
    if abs(bulge) >= _SHALLOW:
        return _distance_from_arc(run, i, end, bulge, math.inf)
    x0, y0 = run[i, 0], run[i, 1]
    dx, dy = run[end - 1, 2] - x0, run[end - 1, 3] - y0
    square = dx * dx + dy * dy
    if square == 0.0:
        return math.inf
    worst = before = 0.0
    for s in range(i, end):
        x, y = run[s, 2] - x0, run[s, 3] - y0
        place = (x * dx + y * dy) / square
        if place <= before or place > 1.0 + 1e-9:
            return math.inf
        before = place
        rise = 0.5 * abs(run[s, 4]) * math.hypot(run[s, 2] - run[s, 0], run[s, 3] - run[s, 1])
        for side in (0, 2):
            x, y = run[s, side] - x0, run[s, side + 1] - y0
            worst = max(worst, abs(y * dx - x * dy) / math.sqrt(square) + rise)
    return worst


@kernel(allocates=False)
def fit_circle(run: F64_2, count: int, tolerance: float) -> tuple[float, float, float, float]:
    """Fit a circle to a closed run of lines.

    Returns
    -------
    x, y, radius, distance
        Centre and radius of the circle, negative if it is traversed clockwise, and the greatest
        distance of the run from it (mm).  The distance is infinite if it exceeds ``tolerance`` or
        if the run does not go round the centre once.

    Notes
    -----
    Algebraic fit of Kåsa, "A circle fitting procedure and its error analysis", IEEE Trans. Instrum.
    Meas. 25 (1976).  The circle passes through the vertices if the chords are within the tolerance
    of it.  Otherwise its radius is the mean of those that touch the vertices and the chords.
    """
    if count < _CIRCLE_CHORDS:
        return 0.0, 0.0, 0.0, math.inf
    mx = my = 0.0
    for s in range(count):
        if abs(run[s, 4]) >= BULGE:
            return 0.0, 0.0, 0.0, math.inf
        mx += run[s, 0]
        my += run[s, 1]
    mx, my = mx / count, my / count
    uu = uv = vv = ru = rv = 0.0
    for s in range(count):
        u, v = run[s, 0] - mx, run[s, 1] - my
        square = u * u + v * v
        uu += u * u
        uv += u * v
        vv += v * v
        ru += square * u
        rv += square * v
    divisor = uu * vv - uv * uv
    if divisor <= 1e-6 * (uu + vv) * (uu + vv):
        return 0.0, 0.0, 0.0, math.inf
    cx = mx + 0.5 * (ru * vv - rv * uv) / divisor
    cy = my + 0.5 * (rv * uu - ru * uv) / divisor
    sense = 0.0
    total, rounds = 0.0, 0
    near, far, inside = math.inf, 0.0, math.inf
    for s in range(count):
        ax, ay = run[s, 0] - cx, run[s, 1] - cy
        bx, by = run[s, 2] - cx, run[s, 3] - cy
        across = ax * by - ay * bx
        if s == 0:
            sense = 1.0 if across > 0.0 else -1.0
        if sense * across <= 0.0:
            return 0.0, 0.0, 0.0, math.inf
        # Each round passes the positive x axis once.
        if ay * sense < 0.0 <= by * sense:
            rounds += 1
        vertex, last = math.hypot(ax, ay), math.hypot(bx, by)
        total += vertex
        near, far = min(near, vertex, last), max(far, vertex, last)
        # A chord is nearest to the centre at its inside only if the perpendicular meets it there.
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        if 0.0 < -(ax * dx + ay * dy) < square:
            inside = min(inside, abs(across) / math.sqrt(square))
    if rounds != 1:
        return 0.0, 0.0, 0.0, math.inf
    radius = total / count
    inside = min(inside, near)
    off = max(far - radius, radius - inside)
    if off > tolerance:
        radius = 0.5 * (far + inside)
        off = 0.5 * (far - inside)
    return cx, cy, sense * radius, off if off <= tolerance else math.inf


@kernel(allocates=False)
def divide_circle(
    run: F64_2, count: int, x: float, y: float, radius: float, first: OutI64_1, arcs: OutF64_2
) -> int:
    """Divide a circle into two or three arcs that start and end in the direction of vertices.

    There are two arcs if a vertex is opposite the first one.

    Parameters
    ----------
    run : (k, 5)
        The closed run of ``count`` lines that the circle replaces.
    x, y, radius
        The circle, as ``fit_circle`` returns it.
    first : (3,)
        Receives the index of the first segment that each arc replaces.
    arcs : (3, 5)
        Receives the arcs: x0, y0, x1, y1, bulge.

    Returns
    -------
    Number of the arcs; 0 if the vertices are too far apart for three arcs.
    """
    sense = 1.0 if radius > 0.0 else -1.0
    ax, ay = run[0, 0] - x, run[0, 1] - y
    first[0] = 0
    number = 1
    is_halved = False
    for s in range(1, count):
        bx, by = run[s, 0] - x, run[s, 1] - y
        turn = sense * math.atan2(ax * by - ay * bx, ax * bx + ay * by)
        if abs(abs(turn) - math.pi) < _OPPOSITE:
            first[1] = s
            number = 2
            is_halved = True
            break
        if turn < 0.0:
            turn += 2.0 * math.pi
        if number < 3 and turn >= number * 2.0 * math.pi / 3.0:
            first[number] = s
            number += 1
    if number != 3 and not is_halved:
        return 0
    for k in range(number):
        start, end = first[k], first[(k + 1) % number]
        for side, vertex in ((0, start), (2, end)):
            bx, by = run[vertex, 0] - x, run[vertex, 1] - y
            scale = abs(radius) / math.hypot(bx, by)
            arcs[k, side], arcs[k, side + 1] = x + scale * bx, y + scale * by
        ux, uy = arcs[k, 0] - x, arcs[k, 1] - y
        vx, vy = arcs[k, 2] - x, arcs[k, 3] - y
        sweep = sense * math.atan2(ux * vy - uy * vx, ux * vx + uy * vy)
        if sweep < 0.0:
            sweep += 2.0 * math.pi
        arcs[k, 4] = sense * (1.0 if is_halved else math.tan(0.25 * sweep))
    return number
