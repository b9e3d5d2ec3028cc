"""Compare the listing of the paper with knifetip: error of the tip at all azimuths.

    python -m tests.benchmarks.vgroove_listing     writes backend/docs/vgroove-listing.md

``AzimuthAngle`` of section 4.3 is translated line by line to arrays.  Its constants are truncated:
1.570796 for π/2, and therefore 3.141592 for Pi, which the listing does not show.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from knifetip.compensation.vgroove import head_offset
from knifetip.model.tool import VCutter

PAGE = Path(__file__).parents[2] / "backend" / "docs" / "vgroove-listing.md"
LENGTHS = (0.1, 1.0, 10.0, 100.0)
BACKS = (6.0, 10.0)
HALF_WIDTH = 1.5
#: Azimuths in steps of a thousandth of a degree.
AZIMUTHS = np.arange(360_000) / 1000.0
_PI = 3.141592


def listing_azimuth(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return AzimuthAngle (degrees) of edges from the origin to (x, y) mm."""
    dx, dy = np.trunc(100.0 * x), np.trunc(100.0 * y)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.arctan(y / x)
    upright = np.where(dy > 0, 1.570796, -1.570796)
    level = np.where(dx > 0, 0.0, -0.000001)
    a = np.where(dx == 0, upright, np.where(dy == 0, level, slope))
    a = a / _PI * 180.0
    a = np.where(dx < 0, a + 180.0, a)
    return np.where(a < 0, a + 360.0, a)


def listing_offset(
    x: NDArray[np.float64], y: NDArray[np.float64], d: float, r: float
) -> NDArray[np.float64]:
    """Return the first point of VdaoPoint for edges to (x, y), (n, 2).

    ``r`` is half of the value that the listing calls r.
    """
    angle = listing_azimuth(x, y) / 180.0 * _PI
    return np.column_stack(
        [d * np.sin(angle) + r * np.cos(angle), -d * np.cos(angle) + r * np.sin(angle)]
    )


def largest_errors(length: float, d: float) -> tuple[float, float]:
    """Return the largest error of the tip (mm) over all azimuths: of the listing, and of
    knifetip.
    """
    turn = np.radians(AZIMUTHS.astype(np.longdouble))
    ends = (length * np.column_stack([np.cos(turn), np.sin(turn)])).astype(np.float64)
    x, y = ends.astype(np.longdouble).T
    size = np.hypot(x, y)
    exact = np.column_stack([d * y + HALF_WIDTH * x, -d * x + HALF_WIDTH * y]) / size[:, None]
    listing = listing_offset(ends[:, 0], ends[:, 1], d, HALF_WIDTH)
    engine = head_offset(np.zeros_like(ends), ends, VCutter(d, HALF_WIDTH, 45.0))
    return (
        float(np.hypot(*(listing - exact).T).max()),
        float(np.hypot(*(engine - exact).T).max()),
    )


def page() -> str:
    """Return the text of backend/docs/vgroove-listing.md."""
    rows = []
    for d in BACKS:
        for length in LENGTHS:
            listing, engine = largest_errors(length, d)
            bound = "less than 1e-14" if engine < 1e-14 else f"{engine:.1e}"
            rows.append(f"| {d:g} | {length:g} | {listing:.4f} | {bound} |")
    return "\n".join(
        [
            "# The V-groove listing of the paper compared with knifetip",
            "",
            "Yang, Du, Shu & Qian print the function that their machine used (section 4.3). It",
            "detects vertical and horizontal edges by coordinate differences truncated to 0.01 mm,",
            "so an edge within 0.01 mm of an axis is treated as parallel to it. The table has the",
            "largest tip error over 360,000 azimuths, a thousandth of a degree apart, in mm, for a",
            f"blade with r = {HALF_WIDTH:g} mm.",
            "`python -m tests.benchmarks.vgroove_listing` writes this page; a test compares.",
            "",
            "| d (mm) | edge (mm) | the listing (mm) | ours (mm) |",
            "|---|---|---|---|",
            *rows,
            "",
            "An edge without length has no azimuth: the listing returns 270°, knifetip refuses it.",
            "",
        ]
    )


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
