"""weights: constants from which the weights of all kinds of evidence for a unit are computed.

A weight is the natural logarithm of a likelihood ratio, so weights are added: 2.3 is ten to one,
4.6 a hundred to one.  The constants are estimates.  They were set so that none of thousands of
generated cartons, in every unit and with right, missing and wrong headers, is read in a wrong unit
(tests/unit/units/test_generated.py).  If the total weights are not conclusive, the user must
choose the unit.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

#: Fraction of carton drawings in each unit, by the unit that the header states ("" for none).
STATED: Final[Mapping[str, Mapping[str, float]]] = {
    # Most countries draw cartons in mm, some in inches; points and pixels come from conversion.
    "": {
        "mm": 0.80,
        "cm": 0.04,
        "m": 0.01,
        "in": 0.10,
        "ft": 0.002,
        "pt": 0.024,
        "px": 0.020,
        "px-90": 0.004,
    },
    # Chosen by the user or by a metric template: nearly always right.
    "mm": {
        "mm": 0.94,
        "cm": 0.008,
        "m": 0.002,
        "in": 0.013,
        "ft": 1e-3,
        "pt": 0.018,
        "px": 0.016,
        "px-90": 0.002,
    },
    # Not the default of a program, but often a setting of the document that its numbers ignore.
    "cm": {
        "mm": 0.18,
        "cm": 0.58,
        "m": 0.01,
        "in": 0.19,
        "ft": 0.005,
        "pt": 0.018,
        "px": 0.015,
        "px-90": 0.002,
    },
    # The default of several libraries that write DXF: more often unchanged than chosen.
    "m": {
        "mm": 0.50,
        "cm": 0.06,
        "m": 0.34,
        "in": 0.06,
        "ft": 0.01,
        "pt": 0.015,
        "px": 0.013,
        "px-90": 0.002,
    },
    # The default template of the most common CAD program: often unchanged over millimetres.
    "in": {
        "mm": 0.20,
        "cm": 0.02,
        "m": 0.003,
        "in": 0.74,
        "ft": 0.017,
        "pt": 0.01,
        "px": 0.008,
        "px-90": 0.002,
    },
    # Cartons are not drawn in feet: the header is often an accident.
    "ft": {
        "mm": 0.25,
        "cm": 0.02,
        "m": 0.01,
        "in": 0.30,
        "ft": 0.40,
        "pt": 0.01,
        "px": 0.008,
        "px-90": 0.002,
    },
    # Only SVG and PDF state points, for pages whose coordinates are scaled to points.
    "pt": {
        "mm": 0.10,
        "cm": 0.005,
        "m": 1e-3,
        "in": 0.03,
        "ft": 1e-3,
        "pt": 0.85,
        "px": 0.011,
        "px-90": 0.002,
    },
    # The program that wrote an SVG defines the length of a pixel.
    "px": {
        "mm": 0.10,
        "cm": 0.005,
        "m": 1e-3,
        "in": 0.03,
        "ft": 1e-3,
        "pt": 0.01,
        "px": 0.85,
        "px-90": 0.003,
    },
    "px-90": {
        "mm": 0.10,
        "cm": 0.005,
        "m": 1e-3,
        "in": 0.03,
        "ft": 1e-3,
        "pt": 0.005,
        "px": 0.008,
        "px-90": 0.85,
    },
}

#: Longer side of a drawing (mm) and its weight, interpolated linearly in log size.  A flat carton
#: is seldom smaller than 100 mm, which separates small drawings in mm from those in cm.  Sizes up
#: to a large sheet are equally likely; displays are larger, and rarer.
SIZE: Final = (
    (1.0, -16.0),
    (10.0, -10.0),
    (20.0, -8.0),
    (40.0, -6.0),
    (60.0, -5.0),
    (100.0, -3.2),
    (140.0, -1.2),
    (180.0, -0.4),
    (220.0, 0.0),
    (1500.0, 0.0),
    (2500.0, -1.0),
    (3500.0, -3.0),
    (6000.0, -6.0),
    (30000.0, -14.0),
)
#: A size with at least this weight is reported as usual for cartons.
USUAL: Final = -2.0

#: Shortest length in a drawing with many edges (mm) and its weight.  Slots, tapers and double
#: creases depend on the caliper of the board, 0.3 to 8 mm.  Trays may have no small features, and
#: curves that were exported as chords have smaller ones.
FEATURE: Final = (
    (0.003, -4.0),
    (0.1, -3.5),
    (0.2, -2.5),
    (0.3, -0.8),
    (0.45, 0.0),
    (5.0, 0.0),
    (25.0, -1.0),
    (60.0, -1.7),
    (200.0, -3.5),
)
#: A drawing with fewer straight edges may have no small features.
FEATURE_EDGES: Final = 8
#: A drawing with fewer edges is a sample or a coupon, not a carton, so its size and lengths are
#: weak evidence: the stated unit is kept if it makes the longer side lie between these (mm).
THIN_EDGES: Final = 8
THIN_SIZE: Final = (2.0, 6000.0)

#: Fraction of lengths in a metric design that are multiples of a grid (mm) but of no coarser grid.
METRIC: Final[Mapping[float, float]] = {
    100.0: 0.01,
    50.0: 0.02,
    10.0: 0.11,
    5.0: 0.12,
    1.0: 0.33,
    0.5: 0.15,
    0.25: 0.02,
    0.1: 0.10,
    0.05: 0.02,
}
#: Fraction of lengths in an inch design that are multiples of a grid (mm) but of no coarser grid.
IMPERIAL: Final[Mapping[float, float]] = {
    25.4 * 4.0: 0.01,
    25.4: 0.11,
    25.4 / 2.0: 0.12,
    25.4 / 4.0: 0.14,
    25.4 / 8.0: 0.17,
    25.4 / 16.0: 0.17,
    25.4 / 32.0: 0.08,
    25.4 / 64.0: 0.02,
    2.54: 0.03,
    1.27: 0.03,
}
#: Fraction of lengths that are multiples of no grid, such as diagonals and calculated lengths: few,
#: some or most, each equally likely.
OFF_GRID: Final = (0.1, 0.4, 0.75)
#: Fraction of the drawings in each unit that are metric designs.
DESIGNED_METRIC: Final[Mapping[str, float]] = {
    "mm": 0.92,
    "cm": 0.98,
    "m": 0.95,
    "in": 0.20,
    "ft": 0.10,
    "pt": 0.80,
    "px": 0.80,
    "px-90": 0.80,
}
#: The grids of these units are multiples of each other, so round numbers in one are round in all.
#: The unit in which they are roundest leads by at most ``FAMILY_ADVANTAGE``: whole centimetres do
#: not prove that a drawing is in centimetres.
FAMILIES: Final = (("mm", "cm", "m"), ("in", "ft"))
FAMILY_ADVANTAGE: Final = 1.2
#: Lengths of panels depend on each other, so the weight does not grow beyond this many lengths.
INDEPENDENT: Final = 8
#: Largest weight of one kind of evidence: each has assumptions that a drawing may violate.
HEAVIEST: Final = 15.0

#: Probability of each unit for a number that is written without one.
BARE: Final[Mapping[str, float]] = {"mm": 0.80, "cm": 0.06, "in": 0.135, "m": 0.004, "ft": 0.001}
#: Probability that a number on the sheet is the length of an edge.
IS_A_LENGTH: Final = 0.5
#: Probability that the overwritten text of a dimension is still its length.
OVERWRITTEN: Final = 0.9
#: If more numbers match, their weights are reduced, because they often depend on each other.
NUMBERS: Final = 6

#: A text such as "all dimensions in mm".
STATEMENT: Final = 2.5
#: In this unit the drawing has the size of a paper sheet (A0 … A5, letter … tabloid).
PAPER: Final = 2.5
#: In this unit the curls at the corners of outlines are as large as those for a laser beam.
CORNER_LOOPS: Final = 4.0
#: Hints of the header (``model.unit.UnitHint``): the units that they support, and the weight.
HINTS: Final[Mapping[str, tuple[tuple[str, ...], float]]] = {
    # Set by the template, seldom by the user: wrong in one file of ten.
    "metric": (("mm", "cm", "m"), 0.7),
    "imperial": (("in", "ft"), 0.7),
    # Notation in feet and inches requires that one unit is one inch.
    "inches": (("in",), 2.5),
    # Dimensions, or their second values, are multiplied by 25.4: inches shown as millimetres.
    "shown × 25.4": (("in",), 2.5),
    "shown × 0.03937": (("mm",), 2.5),
    "shown × 10": (("cm",), 2.0),
    "shown × 1000": (("m",), 2.5),
    # Programs that convert all coordinates to mm: a hundred to one, because another program may
    # have scaled the drawing and kept the header.
    "written in mm": (("mm",), 4.6),
    # Programs without a unit of their own, whose other formats are in mm: ten to one.
    "modelled in mm": (("mm",), 2.3),
    # An SVG without a physical size is as often a page in points or pixels as a carton in mm.
    "pixels": (("pt", "px", "px-90"), 3.5),
}

#: The unit that the header states is kept if its weight is greater by this: a hundred to one.
STATED_MARGIN: Final = 4.6
#: Without a stated unit, the likeliest is chosen if its weight is greater by this: 3,000 to one.
DECISION_MARGIN: Final = 8.0
#: A unit that is not stated is chosen if its weight is greater by this: 8,000 to one.
OVERRULE_MARGIN: Final = 9.0
