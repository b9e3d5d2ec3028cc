"""stretches: the record of the parts into which cuts are split where they meet."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.geometry.columns import F64, I64


@dataclass(frozen=True, eq=False, slots=True)
class Stretches:
    """The m stretches into which n cuts and links across gaps are split where they meet."""

    ends: F64  #: (m, 2, 2) mm
    bulge: F64  #: (m,)
    row: I64  #: (m,) index of the cut; n and more for a link
    face: I64  #: (m, 2) faces beside the stretch; 0 is the plane outside
