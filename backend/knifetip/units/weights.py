"""weights: what evidence for a unit weighs, all in one place, with the reason for each.

Weights are natural logarithms of likelihoods, so they add up: 2.3 is ten to one, 4.6 a hundred to
one.  They are judgements, set so that thousands of generated cartons in every unit, under right,
missing and lying headers, are never read wrong (tests/unit/units/test_generated.py); where they do
not decide, somebody is asked.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

#: How often a drawing of a carton is in each unit, by what its header states ("" for nothing).
STATED: Final[Mapping[str, Mapping[str, float]]] = {
    # Cartons are drawn in mm but where inches are at home; points and pixels come of conversion.
    "": {"mm": 0.80, "cm": 0.04, "m": 0.01, "in": 0.10, "ft": 0.002, "pt": 0.024, "px": 0.024},
    # Said on purpose or by a metric template: nearly always right.
    "mm": {"mm": 0.94, "cm": 0.008, "m": 0.002, "in": 0.013, "ft": 1e-3, "pt": 0.018, "px": 0.018},
    # No program's default, but a unit that people pick for a document and not for its numbers.
    "cm": {"mm": 0.18, "cm": 0.58, "m": 0.01, "in": 0.19, "ft": 0.005, "pt": 0.018, "px": 0.017},
    # The default of several libraries that write DXF: more often left standing than meant.
    "m": {"mm": 0.50, "cm": 0.06, "m": 0.34, "in": 0.06, "ft": 0.01, "pt": 0.015, "px": 0.015},
    # The default of the commonest CAD's template: often left standing on millimetres.
    "in": {"mm": 0.20, "cm": 0.02, "m": 0.003, "in": 0.74, "ft": 0.017, "pt": 0.01, "px": 0.01},
    # Nobody draws cartons in feet: the header is as likely as not an accident.
    "ft": {"mm": 0.25, "cm": 0.02, "m": 0.01, "in": 0.30, "ft": 0.40, "pt": 0.01, "px": 0.01},
    # Only an SVG or a PDF states points, for a page whose coordinates it has scaled to them.
    "pt": {"mm": 0.10, "cm": 0.005, "m": 1e-3, "in": 0.03, "ft": 1e-3, "pt": 0.85, "px": 0.013},
}

#: Longer side of a drawing (mm) and the weight of that; straight lines between, on log size.
#: A flat carton is seldom under 100 mm, which is what tells a small one in mm from one in cm;
#: from there to a large sheet all is the same, and displays thin out.
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
#: What is said of a size with at least this weight: as cartons are.
USUAL: Final = -2.0

#: Shortest length that a drawing of many edges has (mm) and the weight of that: slots, tapers and
#: creases beside each other follow the caliper of boards, 0.3 to 8 mm.  Trays may have nothing
#: small, and curves that came as chords something smaller.
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
#: A drawing of fewer straight edges may do without small features.
FEATURE_EDGES: Final = 8
#: A drawing of fewer edges is a sample or a coupon and no carton, so its size and its numbers say
#: little: what the header states stands if that makes it no smaller and no larger than this (mm).
THIN_EDGES: Final = 8
THIN_SIZE: Final = (2.0, 6000.0)

#: How often a length of a metric design is a multiple of so many mm, and of no coarser grid.
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
#: The same of a design in inches: halves down to 64ths, and decimals.
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
#: How many of a drawing's lengths are on none of the grids, diagonals and what was calculated:
#: few, some or most, each as likely.
OFF_GRID: Final = (0.1, 0.4, 0.75)
#: How often a drawing in this unit is a metric design.
DESIGNED_METRIC: Final[Mapping[str, float]] = {
    "mm": 0.92,
    "cm": 0.98,
    "m": 0.95,
    "in": 0.20,
    "ft": 0.10,
    "pt": 0.80,
    "px": 0.80,
}
#: Grids of these units are multiples of each other, so good numbers in one are good in the rest,
#: and that they are better there weighs no more than ``KIN``: whole centimetres are no proof.
FAMILIES: Final = (("mm", "cm", "m"), ("in", "ft"))
KIN: Final = 1.2
#: Panels repeat and follow from each other, so more lengths than this say nothing new.
INDEPENDENT: Final = 8
#: No kind of evidence weighs more than this: each rests on assumptions that a drawing may break.
HEAVIEST: Final = 15.0

#: The unit of a number that is written without one.
BARE: Final[Mapping[str, float]] = {"mm": 0.80, "cm": 0.06, "in": 0.135, "m": 0.004, "ft": 0.001}
#: How often a number on the sheet is one of its lengths.
MEANT: Final = 0.5
#: How often a dimension that somebody overwrote still gives its length.
OVERWRITTEN: Final = 0.9
#: Numbers that are counted, at most: they often repeat each other.
NUMBERS: Final = 6

#: A sheet that says "all dimensions in mm".
STATEMENT: Final = 2.5
#: The drawing is as large as a sheet of paper in this unit (A0 … A5, letter … tabloid): a frame.
PAPER: Final = 2.5
#: Hints of the header (``model.unit.Hint``): which units they favour, and how much.
HINTS: Final[Mapping[str, tuple[tuple[str, ...], float]]] = {
    # Set by the template, seldom by hand: found wrong in one of ten.
    "metric": (("mm", "cm", "m"), 0.7),
    "imperial": (("in", "ft"), 0.7),
    # Feet-and-inches notation is only right where a unit is an inch.
    "inches": (("in",), 2.5),
    # Dimensions that are multiplied by 25.4, or shown a second time so: millimetres of inches.
    "shown × 25.4": (("in",), 2.5),
    "shown × 0.03937": (("mm",), 2.5),
    "shown × 10": (("cm",), 2.0),
    "shown × 1000": (("m",), 2.5),
    # An SVG without a physical size: as often a page in points or pixels as a carton in mm.
    "pixels": (("pt", "px"), 3.5),
    # Illustrator has a point to a coordinate.
    "points": (("pt",), 3.0),
}

#: The header's unit stands if it leads by this: a hundred to one.
STANDS: Final = 4.6
#: A unit that no header states is decided where it leads by this: 3,000 to one.
DECIDES: Final = 8.0
#: A unit against the header's word is decided where it leads by this: 8,000 to one.
OVERRULES: Final = 9.0
