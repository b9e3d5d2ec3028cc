"""The record of what a tool makes of the board's section across its line."""

from __future__ import annotations

from typing import NamedTuple


class CrossSection(NamedTuple):
    """What a tool makes of the section of a board across its line; None for what it does not have.

    Lengths are in mm, angles in degrees.
    """

    top_width: float | None = None  #: width of the opening in the top face
    flank_angle: float | None = None  #: angle of each flank of a groove from the vertical
    fold_angle: float | None = None  #: angle by which the board folds until the flanks meet
    rim_width: float | None = None  #: width of a wheel's rim
    wheel_radius: float | None = None  #: radius of a wheel
    contact_length: float | None = None  #: length along the line on which a wheel touches the board
    blade_width: float | None = None  #: width of a knife along the line
    blade_angle: float | None = None  #: slant of a knife's leading edge from the vertical
    blade_lead: float | None = None  #: distance by which its cut in the top face is ahead
