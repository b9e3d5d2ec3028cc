"""cartons: three sample cartons of our own design, drawn for given inside or outside dimensions.

They are a tuck-end carton in folding boxboard, a tray with rolled-over end walls in corrugated
board, and a grooved blank for a rigid box in greyboard.  Each is a list of layers with paths, which
``write`` converts to a DXF file.  The cartons close when they are folded, because the dimensions
include allowances for the caliper; comments give the reason for each allowance.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from knifetip.dxf.samples.write import Layer, write_dxf
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64
from knifetip.geometry.path import Paths, path_through

CUT = Layer("CUT", 1)
CREASE = Layer("CREASE", 5, "DASHED")
V_GROOVE = Layer("V-GROOVE", 6, "DASHDOT")


def samples() -> dict[str, bytes]:
    """Return the content of the sample DXF files by file name."""
    return {
        "tuck-end-carton.dxf": write_dxf(tuck_end_carton()),
        "corrugated-tray.dxf": write_dxf(corrugated_tray()),
        "rigid-box-blank.dxf": write_dxf(rigid_box_blank()),
    }


def tuck_end_carton(
    length: float = 90.0, width: float = 45.0, depth: float = 130.0
) -> list[tuple[Layer, Paths]]:
    """Return the layers, with their paths, of a reverse tuck-end carton with slit locks.

    The carton is for folding boxboard up to 0.5 mm.  Its panels from the left: glue flap, front,
    side, back, side.  The upper lid is attached to the back panel and its tuck flap is inserted
    behind the front panel; the lower lid is attached to the front panel and is inserted behind the
    back panel.  The slits in each lid hold the shoulders of the dust flaps.

    Parameters
    ----------
    length : float, mm
        Width of the front and of the back panel, between creases.
    width : float, mm
        Width of the side panel between the front and the back panel, between creases.
    depth : float, mm
        Height of the carton, between the creases of the two lids.
    """
    glue, step, slit, tuck = 15.0, 0.5, 6.0, 16.0
    # The last panel lies outside the glue flap's fold: narrower, so that its edge does not project.
    x = glue + np.cumsum([0.0, length, width, length, width - step])
    # Dust flaps fold first, so they fold one step lower than the lids that lie on them.
    low, high = step, depth - step
    lid = width - step
    ease = 0.8  # each side of the lid, so that it slides in between the side panels

    def lid_at(left: float, right: float, crease: float, direction: float) -> F64:
        """Return the corners of a lid with its tuck flap, from left to right, shape (6, 4).

        The columns are x, y, radius of the fillet at the corner (mm), and bulge of the side after
        the corner.  The lid is between x = ``left`` and x = ``right``, and its crease is at
        y = ``crease``.  ``direction`` is +1 if the lid points upwards from its crease, -1 if it
        points downwards.
        """
        return np.array(
            [
                (left, crease - direction * step, 0.0, 0.0),
                (left + ease, crease + direction * lid, 0.0, 0.0),
                (left + ease + 0.5, crease + direction * (lid + tuck), 11.0, 0.0),
                (right - ease - 0.5, crease + direction * (lid + tuck), 11.0, 0.0),
                (right - ease, crease + direction * lid, 0.0, 0.0),
                (right, crease - direction * step, 0.0, 0.0),
            ]
        )

    def dust_at(tucked: float, hinged: float, crease: float, direction: float) -> F64:
        """Return the corners of a dust flap, from x = ``tucked`` to x = ``hinged``, shape (6, 4).

        The columns are x, y, radius of the fillet at the corner (mm), and bulge of the side after
        the corner.

        Parameters
        ----------
        tucked
            x of the side of the dust flap beside which the tuck flap of the lid is inserted.
        hinged
            x of the other side, which is next to the panel to which the lid is attached.
        crease
            y of the crease of the dust flap.
        direction
            +1 if the dust flap points upwards from its crease, -1 if it points downwards.
        """
        reach = (width + tuck) / 2.0
        shoulder = slit + 2.0
        taper = reach * math.tan(math.radians(15.0))
        sign = math.copysign(1.0, hinged - tucked)
        return np.array(
            [
                (tucked, crease, 0.0, 0.0),
                (tucked, crease + direction * shoulder, 0.0, 0.0),
                (tucked + sign * 3.0, crease + direction * (shoulder + 3.0), 0.0, 0.0),
                (tucked + sign * 4.0, crease + direction * reach, 4.0, 0.0),
                (hinged - sign * taper, crease + direction * reach, 4.0, 0.0),
                (hinged, crease, 0.0, 0.0),
            ]
        )

    notch = _notch(radius=10.0, depth=7.0, lead=3.0)
    slant = glue * math.tan(math.radians(15.0))
    contour = _contour(
        [(0.0, low + slant, 0.0, 0.0)],
        lid_at(x[0], x[1], 0.0, -1.0),
        dust_at(x[2], x[1], low, -1.0)[::-1],
        _sheet_corners(notch, ((x[2] + x[3]) / 2.0, low), (1.0, 0.0)),
        dust_at(x[3], x[4], low, -1.0),
        dust_at(x[4], x[3], high, 1.0),
        lid_at(x[2], x[3], depth, 1.0)[::-1],
        dust_at(x[1], x[2], high, 1.0)[::-1],
        _sheet_corners(notch, ((x[0] + x[1]) / 2.0, high), (-1.0, 0.0)),
        [(x[0], high, 0.0, 0.0), (0.0, high - slant, 0.0, 0.0)],
    )
    # The lid's sides lean, so its crease begins a little inside the panel.
    lean = ease * step / (lid + step)
    creases = [(at, low, at, high) for at in x[:4]]
    slits = []
    for first, last, crease, lid_direction in ((x[2], x[3], depth, 1.0), (x[0], x[1], 0.0, -1.0)):
        folds = crease + lid_direction * lid
        creases += [
            (first + lean, crease, last - lean, crease),
            (first + ease + slit, folds, last - ease - slit, folds),
        ]
        slits += [
            (first + ease, folds, first + ease + slit, folds),
            (last - ease - slit, folds, last - ease, folds),
        ]
    creases += [(x[side], at, x[side + 1], at) for at in (low, high) for side in (1, 3)]
    lowest = np.array([0.0, lid + tuck])
    return [
        (CUT, _shifted_paths(_split_paths(contour), lowest)),
        (CUT, _shifted_paths(_lines(slits), lowest)),
        (CREASE, _shifted_paths(_lines(creases), lowest)),
    ]


def corrugated_tray(
    length: float = 280.0, width: float = 200.0, height: float = 80.0, caliper: float = 3.0
) -> list[tuple[Layer, Paths]]:
    """Return the layers, with their paths, of a corrugated tray after FEFCO 0422.

    The end walls are rolled over the corner flaps, and tabs on the end walls lock in slots of the
    base.

    Parameters
    ----------
    length, width, height : float, mm
        Inside dimensions of the tray.
    caliper : float, mm
        Thickness t of the board.  A crease is in the middle of its board.  The distance between two
        creases is therefore the inside dimension, plus t/2 for each board that has one of the
        creases, plus t for each board between them.
    """
    t = caliper
    side = width / 2.0 + t / 2.0
    end = length / 2.0 + 2.5 * t  # inner wall and corner flap are inside the outer wall
    corner = length / 2.0 + 1.5 * t  # the corner flap, between inner and outer wall
    ridge, fold = end + height, end + height + 2.0 * t  # rolled over two boards
    free = fold + height - t / 2.0 - 0.5  # inner wall's edge, on the base
    outer, inner = side - 1.0, width / 2.0 - 1.0  # half widths of the end walls
    foot = side + t / 2.0 + 1.5  # the corner flap does not touch the base
    head = side + height - t / 2.0 - 0.5  # and under the roll-over
    rim = side + height + t / 2.0
    tab, reach = (0.2 * width, 0.38 * width), t + 0.5  # through the base, flush with its underside
    flap = 0.26 * width  # ends before the hand hole
    quarter = np.array(
        [
            (free, tab[0], 0.0, 0.0),
            (free + reach, tab[0] + 1.0, 1.5, 0.0),
            (free + reach, tab[1] - 1.0, 1.5, 0.0),
            (free, tab[1], 0.0, 0.0),
            (free, inner, 4.0, 0.0),
            (fold, inner, 0.0, 0.0),
            (ridge, outer, 0.0, 0.0),
            (corner, outer, 0.0, 0.0),
            (corner, foot, 0.0, 0.0),
            (corner + flap, foot + 3.0, 8.0, 0.0),
            (corner + flap, head - 3.0, 8.0, 0.0),
            (corner, head, 0.0, 0.0),
            (corner, rim, 0.0, 0.0),
        ]
    )
    contour = _contour(*_four_quarters(quarter))

    inside = []
    for sign in (-1.0, 1.0):
        grip = height * 0.6
        inside += [
            _oblong((sign * (end + grip), 0.0), 0.375 * width, 12.5),
            # A little larger, so that the two need not meet exactly.
            _oblong((sign * (fold + height - grip), 0.0), 0.375 * width + 2.0, 13.5),
        ]
        wall = sign * (length / 2.0 + t / 2.0)
        inside += [
            _rectangle(wall, middle * (tab[0] + tab[1]) / 2.0, t + 0.5, tab[1] - tab[0] + 2.0)
            for middle in (-1.0, 1.0)
        ]
    creases = [(-corner, sign * side, corner, sign * side) for sign in (-1.0, 1.0)]
    for sign in (-1.0, 1.0):
        creases += [
            (sign * at, -half, sign * at, half)
            for at, half in ((end, outer), (ridge, outer), (fold, inner))
        ]
        creases += [(sign * corner, up * foot, sign * corner, up * head) for up in (-1.0, 1.0)]
    lowest = np.array([free + reach, rim])
    return [
        (CUT, _shifted_paths(contour, lowest)),
        *((CUT, _shifted_paths(hole, lowest)) for hole in inside),
        (CREASE, _shifted_paths(_lines(creases), lowest)),
    ]


def rigid_box_blank(
    length: float = 220.0, width: float = 150.0, height: float = 50.0, caliper: float = 2.0
) -> list[tuple[Layer, Paths]]:
    """Return the layers, with their paths, of a rigid box in one piece with four V-grooves.

    The grooves surround the base.  The board folds at the bottom of the grooves, so that the
    distances between the grooves are the outside dimensions of the box.  The long walls have the
    full length of the box.  The short walls fit between them: at each end, a short wall is shorter
    by the caliper and 0.2 mm, and its outline leads to the corner of the base at 45 degrees.

    Parameters
    ----------
    length, width, height : float, mm
        Outside dimensions of the box.
    caliper : float, mm
        Thickness of the greyboard.
    """
    x, y = length / 2.0, width / 2.0
    mitre = caliper + 0.2  # room for the wrap's turn-in
    quarter = np.array(
        [
            (x + height, y - mitre, 0.0, 0.0),
            (x + mitre, y - mitre, 0.0, 0.0),
            (x, y, 0.0, 0.0),
            (x, y + height, 0.0, 0.0),
        ]
    )
    first, second, third, fourth = _four_quarters(quarter)
    notch = _notch(radius=13.0, depth=9.0, lead=4.0)
    contour = _contour(
        _sheet_corners(notch, (x + height, 0.0), (0.0, 1.0)),
        first,
        second,
        _sheet_corners(notch, (-x - height, 0.0), (0.0, -1.0)),
        third,
        fourth,
    )
    grooves = [(-x, -y, x, -y), (x, -y, x, y), (x, y, -x, y), (-x, y, -x, -y)]
    lowest = np.array([x + height, y + height])
    return [
        (CUT, _shifted_paths(contour, lowest)),
        (V_GROOVE, _shifted_paths(_lines(grooves), lowest)),
    ]


def _contour(*parts: ArrayLike) -> Paths:
    """Return one closed path through the corners in ``parts``, with fillets at the corners.

    Parameters
    ----------
    *parts : (k, 4)
        Arrays of successive corners: x, y, radius of the fillet at the corner (mm), 0 for none, and
        bulge of the side that follows the corner.  The two sides at a fillet must be straight.
    """
    corners = np.concatenate([np.asarray(part, np.float64) for part in parts])
    repeated = np.hypot(*(corners[:, :2] - np.roll(corners[:, :2], 1, axis=0)).T) < 1e-9
    corners = corners[~repeated]
    at, radius, bulge = corners[:, :2], corners[:, 2], corners[:, 3]
    incoming = unit_vectors(at - np.roll(at, 1, axis=0))
    away = np.roll(incoming, -1, axis=0)
    turn = np.arctan2(
        incoming[:, 0] * away[:, 1] - incoming[:, 1] * away[:, 0], (incoming * away).sum(axis=1)
    )
    back = (radius * np.tan(np.abs(turn) / 2.0))[:, None]
    round_ = radius > 0
    vertices = np.stack([at - back * incoming, at + back * away], axis=1)
    bulges = np.stack([np.where(round_, np.tan(turn / 4.0), bulge), bulge], axis=1)
    kept = np.stack([np.ones_like(round_), round_], axis=1)
    xy = vertices[kept]
    return path_through(np.vstack([xy, xy[:1]]), bulges[kept])


def _notch(radius: float, depth: float, lead: float) -> F64:
    """Return the corners of a thumb notch in the edge of a panel, shape (4, 4).

    The notch is an arc of radius ``radius`` that reaches ``depth`` into the board.  At each side a
    fillet of radius ``lead`` leads from the edge into the arc (all in mm).  The board is to the
    left of the edge, and the middle of the notch is at u = 0.

    The columns of the returned array are u along the edge (mm), v into the board (mm), radius of
    the fillet that ``_contour`` adds at the corner, and bulge of the side after the corner.  The
    radius is 0, because the two fillets of the notch are already sides with a bulge.

    The centre of the arc is ``radius - depth`` outside the board.  The common tangent of the arc
    and a fillet therefore makes the angle φ with the edge, with
    cos φ = (radius - depth + lead) / (radius + lead).
    """
    turned = math.acos((radius - depth + lead) / (radius + lead))
    half = (radius + lead) * math.sin(turned)
    inner, sunk = half - lead * math.sin(turned), lead * (1.0 - math.cos(turned))
    edge, belly = math.tan(turned / 4.0), -math.tan(turned / 2.0)
    return np.array(
        [
            (-half, 0.0, 0.0, edge),
            (-inner, sunk, 0.0, belly),
            (inner, sunk, 0.0, edge),
            (half, 0.0, 0.0, 0.0),
        ]
    )


def _sheet_corners(corners: F64, origin: tuple[float, float], axis: tuple[float, float]) -> F64:
    """Convert corners of a contour from coordinates along an edge to the coordinates of the sheet.

    The columns of ``corners`` and of the returned array, (k, 4), are the two coordinates, radius of
    the fillet at the corner (mm), and bulge of the side after the corner.

    Parameters
    ----------
    corners : (k, 4)
        Corners with the coordinates u along the edge and v to the left of the edge.
    origin
        Point u = v = 0 in the coordinates of the sheet.
    axis
        Unit vector along the edge, in the coordinates of the sheet.
    """
    u = np.array(axis)
    xy = origin + corners[:, :1] * u + corners[:, 1:2] * left_normal(u)
    return np.hstack([xy, corners[:, 2:]])


def _four_quarters(quarter: F64) -> list[F64]:
    """Return the corners of the four quarters of a contour that is symmetrical to the x and y axes.

    ``quarter`` contains the corners of the quarter with positive x and y, counter-clockwise.  The
    returned list contains this array and its three mirror images, in counter-clockwise order.  The
    columns of an array, (k, 4), are x, y, radius of the fillet at the corner, and bulge.
    """
    backwards = quarter[::-1]
    return [
        quarter,
        backwards * (-1.0, 1.0, 1.0, 1.0),
        quarter * (-1.0, -1.0, 1.0, 1.0),
        backwards * (1.0, -1.0, 1.0, 1.0),
    ]


def _oblong(centre: tuple[float, float], length: float, radius: float) -> Paths:
    """Return the closed path of a hole with semicircular ends, ``length`` mm long in y.

    ``centre`` is the centre of the hole, and ``radius`` the radius of its ends (mm).
    """
    x, y = centre
    straight = length / 2.0 - radius
    xy = np.array(
        [
            (x + radius, y - straight),
            (x + radius, y + straight),
            (x - radius, y + straight),
            (x - radius, y - straight),
            (x + radius, y - straight),
        ]
    )
    return path_through(xy, np.array([0.0, 1.0, 0.0, 1.0]))


def _rectangle(x: float, y: float, width: float, height: float) -> Paths:
    corners = np.array([(1, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)])
    return path_through(corners * (width / 2.0, height / 2.0) + np.array([x, y]), np.zeros(4))


def _lines(rows: ArrayLike) -> Paths:
    """Return a separate path for each row of ``rows``, (k, 4): x, y of the start and of the end."""
    ends = np.asarray(rows, np.float64)
    return _split_paths(
        Paths(ends[:, :2], ends[:, 2:], np.zeros(len(ends)), np.array([0, len(ends)]))
    )


def _split_paths(paths: Paths) -> Paths:
    """Return the segments of ``paths``, each as a path of one segment."""
    numbers = np.arange(len(paths.bulge) + 1, dtype=np.int32)
    return Paths(paths.start, paths.end, paths.bulge, numbers)


def _shifted_paths(paths: Paths, shift: F64) -> Paths:
    """Return ``paths`` shifted by the vector ``shift``, (2,) mm, with rounded coordinates.

    Coordinates are rounded to nanometres, because the file would otherwise contain numbers such as
    251.00000000000003.
    """
    start, end = (paths.start + shift).round(6), (paths.end + shift).round(6)
    # Adding 0 makes a zero of minus zero.
    return Paths(start + 0.0, end + 0.0, paths.bulge.round(12), paths.first)
