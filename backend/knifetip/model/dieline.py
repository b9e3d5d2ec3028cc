"""Records of a dieline: the edges of a drawing with line types and the reasons for them."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum

import numpy as np

from knifetip.geometry.columns import F64, I32, U8, freeze
from knifetip.messages import Message


class LineType(IntEnum):
    """The operation that makes an edge, such as cut or crease, or the reason for no operation."""

    UNCLASSIFIED = 0
    CUT = 1
    CREASE = 2
    V_GROOVE = 3
    PERFORATION = 4
    HALF_CUT = 5
    IGNORED = 6
    COMBI = 7

    @property
    def word(self) -> str:
        """Name of the line type in files, JSON data and the web page, such as ``v-groove``."""
        return self.name.lower().replace("_", "-")

    @classmethod
    def from_word(cls, word: str) -> LineType:
        """Return the line type with the name ``word``; case, ``-``, ``_`` and spaces do not matter.

        Raises
        ------
        ValueError
            No line type has that name.
        """
        try:
            return cls[word.strip().upper().replace("-", "_").replace(" ", "_")]
        except KeyError:
            names = ", ".join(kind.word for kind in cls)
            raise ValueError(f"{word!r} is not a line type; they are {names}") from None


@dataclass(frozen=True, eq=False, slots=True)
class Dieline:
    """n edges with their line types, in the order of the drawing; they are not joined to paths."""

    ends: F64  #: (n, 2, 2) mm
    bulge: F64  #: (n,) tan(sweep / 4)
    line_type: U8  #: (n,) LineType
    source: I32  #: (n,) row of the edge in the drawing
    rule: I32  #: (n,) index into ``rules``; -1 for no rule
    confidence: F64  #: (n,) confidence in the line type, 0 … 1
    rules: tuple[Message, ...]  #: reasons for line types, such as ``layer "FOLDS"``
    #: for each item of ``rules`` the other possible line types, most likely first
    alternatives: tuple[tuple[LineType, ...], ...] = ()
    #: (n, 2) faces on the left and on the right of the longest piece of each edge, -1 for the
    #: outside of all contours; -1 on both sides if the edge is in no part or has no length
    face: I32 = field(default_factory=lambda: np.zeros((0, 2), np.int32))
    #: (n,) number that is equal for the edges of one blank and all edges inside it, -1 for none
    part: I32 = field(default_factory=lambda: np.zeros(0, np.int32))
    #: (n,) greatest distance of each edge from the curve of the file that it approximates (mm), see
    #: ``Drawing.fit_error``; default 0
    fit_error: F64 = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "ends", freeze(self.ends, np.float64, -1, 2, 2))
        rows = len(self.ends)
        put(self, "bulge", freeze(self.bulge, np.float64, rows))
        put(self, "line_type", freeze(self.line_type, np.uint8, rows))
        put(self, "source", freeze(self.source, np.int32, rows))
        put(self, "rule", freeze(self.rule, np.int32, rows))
        put(self, "confidence", freeze(self.confidence, np.float64, rows))
        for name, shape in (("face", (rows, 2)), ("part", (rows,))):
            column = getattr(self, name)
            filled = column if len(column) else np.full(shape, -1, np.int32)
            put(self, name, freeze(filled, np.int32, *shape))
        fit_error = self.fit_error if len(self.fit_error) else np.zeros(rows)
        put(self, "fit_error", freeze(fit_error, np.float64, rows))
        spare = len(self.rules) - len(self.alternatives)
        if spare < 0:
            raise ValueError("more alternatives than rules")
        put(self, "alternatives", self.alternatives + ((),) * spare)

    def __len__(self) -> int:
        return len(self.ends)
