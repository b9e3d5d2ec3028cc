"""Small correct programs for every operation and tool, with their dielines, machines and boards."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

from knifetip import compensate, plan, process, sequence
from knifetip.library import load
from knifetip.model.board import Board, Deflection
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Machine
from knifetip.model.operation import Operation
from knifetip.model.verdict import Verdict
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges, with_dimensions

DEMO, ROUTER = load.machine("demo-table"), load.machine("router-table")
GREY, THICK = load.board("greyboard-2.0"), load.board("greyboard-3.0")
SOFT = replace(THICK, deflection=(Deflection("Router", 0.08, 0.05),))

BLANK = (LineType.CUT, closed((100, 100), (220, 100), (220, 180), (100, 180)))
#: Two V-grooves: one runs out of the blank obliquely, one ends inside.
GROOVES = dieline(
    BLANK, (LineType.V_GROOVE, edges(((140, 140), (180, 180)), ((120, 120), (120, 160))))
)
#: Two creases that cross, and six dashes.
FOLDS = dieline(
    BLANK,
    (LineType.CREASE, edges(((120, 100), (120, 180)), ((100, 160), (220, 160)))),
    (LineType.CREASE, edges(*[((140 + 9 * k, 120), (146 + 9 * k, 120)) for k in range(6)])),
)
#: A blank with a round side, a hole, and a slit inside the panel.
ROUNDED = dieline(
    BLANK,
    (LineType.CUT, edges(((130, 140), (150, 140)), ((150, 140), (130, 140)))),
    (LineType.CUT, edges(((170, 120), (200, 150)))),
    bulge={4: 1.0, 5: 1.0, 1: 0.2},
)
PARTIAL_CUTS = dieline(
    BLANK,
    (LineType.HALF_CUT, edges(((120, 100), (120, 180)))),
    (LineType.PERFORATION, edges(((140, 120), (172, 120)))),
    (LineType.COMBI, edges(((140, 150), (200, 150)))),
)
#: A blank with a notch and a round side, a hole with a round side, and a slit.
MILLED = dieline(
    (
        LineType.CUT,
        closed((100, 100), (200, 100), (200, 140), (150, 140), (150, 160), (100, 160)),
    ),
    (LineType.CUT, closed((110, 110), (130, 110), (130, 130), (110, 130))),
    (LineType.CUT, edges(((160, 110), (185, 125)))),
    bulge={1: 0.2, 6: -0.1},
)


def with_knife(**dimensions: float) -> Machine:
    """Return the demo table with other dimensions of its knife."""
    knife = with_dimensions(DEMO.stations[0].tool, **dimensions)
    return replace(DEMO, stations=(replace(DEMO.stations[0], tool=knife), *DEMO.stations[1:]))


def unchanged(operations: list[Operation]) -> list[Operation]:
    return operations


@dataclass(frozen=True)
class Engine:
    """A dieline with the machine, board and settings with which its program is compiled and
    verified.
    """

    name: str
    line: Dieline
    machine: Machine
    board: Board
    dialect: str
    corner: str = "B"

    def __str__(self) -> str:
        return self.name

    def program_bytes(
        self, change: Callable[[list[Operation]], list[Operation]] = unchanged
    ) -> bytes:
        """Return the bytes of the program; ``change`` modifies the planned operations."""
        operations = change(plan(self.line, self.machine, self.board))
        work = [compensate(replace(each, corner=self.corner)) for each in operations]
        return process(sequence(work, self.machine), self.machine, self.dialect).text

    @cached_property
    def text(self) -> bytes:
        """The bytes of the program without modifications."""
        return self.program_bytes()

    def verdict_of(self, text: bytes) -> Verdict:
        """Return the verdict on a program, verified with the dieline, machine and board of the
        engine.
        """
        return verify(text, self.line, (0.0, 0.0), self.machine, self.board)


ENGINES = {
    engine.name: engine
    for engine in (
        Engine("V-groove", GROOVES, DEMO, GREY, "grblhal"),
        Engine("V-groove in passes", GROOVES, DEMO, replace(GREY, groove_pass=0.7), "linuxcnc"),
        Engine("crease", FOLDS, DEMO, GREY, "linuxcnc"),
        Engine("double crease", FOLDS, DEMO, replace(GREY, double_crease=3.0), "grblhal"),
        Engine("knife", ROUNDED, DEMO, GREY, "linuxcnc"),
        Engine("partial cuts", PARTIAL_CUTS, DEMO, GREY, "grblhal"),
        Engine(
            "bridges",
            dieline(BLANK),
            DEMO,
            replace(GREY, bridge_width=0.8, bridge_spacing=150.0),
            "grblhal",
        ),
        Engine("drag knife", ROUNDED, with_knife(trail=4.0, oscillating=False), GREY, "linuxcnc"),
        Engine("knife with leads", ROUNDED, with_knife(lead_in=5.0, lead_out=5.0), GREY, "grblhal"),
        Engine("router B", MILLED, ROUTER, THICK, "linuxcnc", "B"),
        Engine("router C", MILLED, ROUTER, THICK, "grblhal", "C"),
        Engine("router D, deflected", MILLED, ROUTER, SOFT, "linuxcnc", "D"),
        Engine("router auto", MILLED, ROUTER, SOFT, "grblhal", "auto"),
    )
}
