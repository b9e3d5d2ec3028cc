"""Records of a verdict: the findings of the verifier about a program, and edge measurements."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np

from knifetip.geometry.columns import F64, I32, freeze
from knifetip.messages import Message, render
from knifetip.model.edge_figures import EDGE_FIGURES, EdgeFigures
from knifetip.model.program_figures import ProgramFigures


class Severity(StrEnum):
    """What a finding of the verifier means for the program."""

    #: The program is wrong or dangerous.  It is refused, and no user can accept the fault.
    FAULT = "fault"
    #: The tool cannot make an edge as it is drawn, but the program is safe.  The program is refused
    #: until a user accepts the shortfall.
    SHORTFALL = "shortfall"
    #: The program leaves out or changes something as planned.  It is not refused.
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Acceptance:
    """A user's decision to make a program although it has a certain shortfall."""

    by: str  #: name of the user
    reason: str
    at: float  #: time (seconds since 1970)


@dataclass(frozen=True, slots=True)
class Finding:
    """A fault, shortfall or note of the verifier, with its position and measured value."""

    #: deviation, overcut, uncut, stray, depth, heading, order, feed, travel, program, unreached,
    #: kerf, fold, beside, near, registration or planned
    kind: str
    message: Message  #: what was found, without edge and program line
    measure: float  #: measured value (mm; degrees for a heading and a fold)
    edge: int = -1  #: row of the edge in the dieline, -1 for none
    line: int = -1  #: program line, counted from 1; -1 for none
    severity: Severity = Severity.FAULT
    acceptance: Acceptance | None = None  #: of a shortfall that a user has accepted
    #: rows of all drawn edges that the tool makes as one with ``edge``, such as the chords of a
    #: curve, first ``edge`` itself; empty if it is the only one
    edges: tuple[int, ...] = ()

    @property
    def all_edges(self) -> tuple[int, ...]:
        """Rows of the drawn edges that the finding concerns, each once."""
        return self.edges or ((self.edge,) if self.edge >= 0 else ())

    @property
    def refuses(self) -> bool:
        """Whether the program is refused because of this finding."""
        if self.severity is Severity.SHORTFALL:
            return self.acceptance is None
        return self.severity is Severity.FAULT

    @property
    def located_message(self) -> Message:
        """The message of the finding, with the numbers of its edge and program line, if any."""
        if self.edge >= 0 and self.line >= 0:
            return Message(
                "finding.at-edge-and-line", edge=self.edge, line=self.line, fault=self.message
            )
        if self.edge >= 0:
            return Message("finding.at-edge", edge=self.edge, fault=self.message)
        if self.line >= 0:
            return Message("finding.at-line", line=self.line, fault=self.message)
        return self.message

    @property
    def text(self) -> str:
        """The text of the finding in English, with the numbers of its edge and program line."""
        return render(self.located_message)


def _empty_column() -> F64:
    return np.zeros(0)


@dataclass(frozen=True, eq=False, slots=True)
class Samples:
    """Deviations of the tool's tip from the edges at m points of the edges, for the web page.

    The number m is at most 200,000.
    """

    edge: I32 = field(
        default_factory=lambda: np.zeros(0, np.int32)
    )  #: (m,) row of the edge in the dieline
    place: F64 = field(default_factory=_empty_column)  #: (m,) position along the edge, 0 … 1
    deviation: F64 = field(default_factory=_empty_column)  #: (m,) mm to the left of the edge

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "edge", freeze(self.edge, np.int32, -1))
        put(self, "place", freeze(self.place, np.float64, len(self.edge)))
        put(self, "deviation", freeze(self.deviation, np.float64, len(self.edge)))


@dataclass(frozen=True, eq=False, slots=True)
class UnreachedAreas:
    """q areas in the waste that the cutter cannot reach, bounded by m lines and arcs in total."""

    ends: F64 = field(default_factory=lambda: np.zeros((0, 2, 2)))  #: (m, 2, 2) mm
    bulge: F64 = field(default_factory=_empty_column)  #: (m,) tan(sweep / 4)
    first: I32 = field(
        default_factory=lambda: np.zeros(1, np.int32)
    )  #: (q + 1,) first row of each contour
    area: F64 = field(default_factory=_empty_column)  #: (q,) mm²

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "bulge", freeze(self.bulge, np.float64, -1))
        put(self, "ends", freeze(self.ends, np.float64, len(self.bulge), 2, 2))
        put(self, "area", freeze(self.area, np.float64, -1))
        put(self, "first", freeze(self.first, np.int32, len(self.area) + 1))

    def __len__(self) -> int:
        return len(self.area)


@dataclass(frozen=True, eq=False, slots=True)
class Verdict(EdgeFigures):
    """The verifier's verdict on a program: accepted or refused, with findings and measurements.

    The measurements of n edges, such as the deviation, are the columns of ``EdgeFigures``.
    """

    accepted: bool
    tolerance: float  #: mm
    findings: tuple[Finding, ...]
    seconds: float  #: nominal machine time of the program: lengths over feeds
    program: ProgramFigures = field(default_factory=ProgramFigures)
    samples: Samples = field(default_factory=lambda: Samples())
    areas: UnreachedAreas = field(
        default_factory=lambda: UnreachedAreas()
    )  #: areas no cutter can reach

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "deviation", freeze(self.deviation, np.float64, -1))
        rows = len(self.deviation)
        for name, figure in EDGE_FIGURES.items():
            column = getattr(self, name)
            if not figure.is_always_measured and len(column) == 0:
                column = np.zeros(rows)
            put(self, name, freeze(column, np.float64, rows))
