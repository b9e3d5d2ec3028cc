"""cartons: three sample cartons of our own design, drawn for given inside or outside dimensions.

They are a tuck-end carton in folding boxboard, a tray with rolled-over end walls in corrugated
board, and a grooved blank for a rigid box in greyboard.  Each is a list of layers with paths, which
``write`` converts to a DXF file.  The cartons close when they are folded, because the dimensions
include allowances for the caliper; comments give the reason for each allowance.
"""

from __future__ import annotations

import numpy as np

from knifetip.dxf.samples.contours import (
    CREASE,
    CUT,
    V_GROOVE,
    four_quarters,
    oblong,
    rectangle,
    separate_lines,
    sheet_corners,
    shifted_paths,
    thumb_notch,
)
from knifetip.dxf.samples.tuck_end import tuck_end_carton
from knifetip.dxf.samples.write import Layer, write_dxf
from knifetip.geometry.path import Paths
from knifetip.geometry.rounded_contour import closed_contour


def samples() -> dict[str, bytes]:
    """Return the content of the sample DXF files by file name."""
    return {
        "tuck-end-carton.dxf": write_dxf(tuck_end_carton()),
        "corrugated-tray.dxf": write_dxf(corrugated_tray()),
        "rigid-box-blank.dxf": write_dxf(rigid_box_blank()),
    }


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
    tip = 0.4 * t + 0.55  # a knife in thick board needs a larger radius at the tabs' corners
    flap = 0.26 * width  # ends before the hand hole
    quarter = np.array(
        [
            (free, tab[0], 0.0, 0.0),
            (free + reach, tab[0] + 1.0, tip, 0.0),
            (free + reach, tab[1] - 1.0, tip, 0.0),
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
    contour = closed_contour(*four_quarters(quarter))

    inside = []
    for sign in (-1.0, 1.0):
        grip = height * 0.6
        inside += [
            oblong((sign * (end + grip), 0.0), 0.375 * width, 12.5),
            # A little larger, so that the two need not meet exactly.
            oblong((sign * (fold + height - grip), 0.0), 0.375 * width + 2.0, 13.5),
        ]
        wall = sign * (length / 2.0 + t / 2.0)
        inside += [
            rectangle(wall, middle * (tab[0] + tab[1]) / 2.0, t + 0.5, tab[1] - tab[0] + 2.0)
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
        (CUT, shifted_paths(contour, lowest)),
        *((CUT, shifted_paths(hole, lowest)) for hole in inside),
        (CREASE, shifted_paths(separate_lines(creases), lowest)),
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
    first, second, third, fourth = four_quarters(quarter)
    notch = thumb_notch(radius=13.0, depth=9.0, lead=4.0)
    contour = closed_contour(
        sheet_corners(notch, (x + height, 0.0), (0.0, 1.0)),
        first,
        second,
        sheet_corners(notch, (-x - height, 0.0), (0.0, -1.0)),
        third,
        fourth,
    )
    grooves = [(-x, -y, x, -y), (x, -y, x, y), (x, y, -x, y), (-x, y, -x, -y)]
    lowest = np.array([x + height, y + height])
    return [
        (CUT, shifted_paths(contour, lowest)),
        (V_GROOVE, shifted_paths(separate_lines(grooves), lowest)),
    ]
