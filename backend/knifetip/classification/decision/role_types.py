"""role_types: the line types that edges in each role of a drawing's shape may have."""

from __future__ import annotations

from typing import Final

from knifetip.classification.shape.roles import HOLES, NOT_CARTON, Role
from knifetip.model.dieline import LineType

#: Confidence that edges in these roles are ignored.
IGNORED_CONFIDENCE: Final[dict[Role, float]] = {
    Role.FRAME: 0.85,
    Role.ARROW: 0.95,
    Role.BLEED: 0.9,
    Role.LETTER: 0.85,
    Role.DEBRIS: 0.85,
    Role.NAMED: 0.9,
    Role.LEGEND: 0.95,
    Role.DIMENSION: 0.95,
    Role.MEASURED: 0.6,
}
_CUT_FIRST: Final = (LineType.CUT, LineType.IGNORED, LineType.CREASE)
#: Possible line types of each role, the likeliest first.
POSSIBLE_TYPES: Final[dict[Role, tuple[LineType, ...]]] = {
    **dict.fromkeys(Role, _CUT_FIRST),
    Role.DIVIDER: (LineType.CREASE, LineType.CUT, LineType.PERFORATION, LineType.V_GROOVE),
    Role.SLIT: (LineType.CUT, LineType.CREASE, LineType.IGNORED),
    Role.FREE: (LineType.CUT, LineType.CREASE, LineType.IGNORED),
    **dict.fromkeys(HOLES, (LineType.CUT, LineType.HALF_CUT, LineType.IGNORED)),
    **dict.fromkeys(NOT_CARTON, (LineType.IGNORED, LineType.CUT)),
    Role.MEASURED: (LineType.IGNORED, LineType.CREASE, LineType.CUT),
}


def likeliest_type(role: Role) -> LineType:
    """Return the likeliest line type of edges with the given role in the shape of a drawing."""
    return POSSIBLE_TYPES[role][0]
