"""Random jobs: a sheet of cartons, a board of the library, and a machine of the library."""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random
from typing import Final

from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.corners import Corners
from knifetip.model.dieline import LineType
from knifetip.model.job_options import JobOptions
from knifetip.model.machine import Machine
from knifetip.model.sheet import Sheet
from tests.cartons.blank import Blank
from tests.cartons.bodies import add_bodies
from tests.cartons.draft import KINDS, Draft, Habit, habit
from tests.cartons.features import add_features
from tests.cartons.styles import STYLES

MACHINES: Final[tuple[str, ...]] = (
    "demo-table",
    "two-carriage-table",
    "router-table",
    "laser-table",
    "flat-cutter-hpgl",
)
BOARDS: Final[tuple[str, ...]] = (
    *("fbb-0.4", "e-flute", "b-flute"),
    *("greyboard-1.5", "greyboard-2.0", "greyboard-3.0"),
)
#: Width of a table on which cartons fit (mm).
_LEAST_WIDTH: Final = 1000.0


@dataclass(frozen=True)
class Job:
    """A file, the line type of each style in it, and what to make of it."""

    number: int
    style: str
    data: bytes
    habit: Habit
    machine: Machine
    board: Board
    dialect: str
    options: JobOptions

    @property
    def truth(self) -> dict[tuple[str, int], LineType]:
        """Line type by layer and colour."""
        return {self.habit.style(kind): LineType.from_word(kind) for kind in KINDS}

    def __str__(self) -> str:
        return f"{self.number} {self.style}, {self.machine.name}, {self.board.name}"


def random_job(seed: int, number: int, *, bodies: bool = False) -> Job:
    """Return the job with a number in the sequence of a seed.

    With ``bodies``, machine and board are any of the library, and panels have bends and lines side
    by side.
    """
    rng = Random(f"{seed}/{number}")
    machines, boards = MACHINES, BOARDS
    if bodies:
        # On smaller tables most cartons do not fit.
        machines = tuple(n for n in load.names("machines") if load.machine(n).width > _LEAST_WIDTH)
        boards = tuple(load.names("boards"))
    machine, board = load.machine(rng.choice(machines)), load.board(rng.choice(boards))
    while board.caliper + machine.clearance > machine.travel_z:
        board = load.board(rng.choice(boards))
    style = rng.choice(sorted(STYLES))
    blank = STYLES[style](rng, board.caliper)
    add_bodies(blank, rng, board.caliper) if bodies else add_features(blank, rng, board.caliper)
    draft = Draft(habit(rng), rng)
    _draw(draft, blank, rng)
    dialect = machine.dialect
    if dialect == "linuxcnc" and not machine.gantry and rng.random() < 0.3:
        dialect = "grblhal"
    return Job(
        number,
        style,
        draft.bytes(),
        draft.habit,
        machine,
        board,
        dialect,
        JobOptions(
            corners=Corners(type=rng.choice(["auto", "B", "C", "D"]))
            if machine.offset_cuts
            else None,
            sheet=rng.choice([None, None, None, Sheet()]),
            lift="least" if machine.turn_clearance and rng.random() < 0.3 else "clearance",
        ),
    )


def _draw(draft: Draft, blank: Blank, rng: Random) -> None:
    """Draw one blank, or a sheet of several, at a random angle."""
    turn = rng.choice([0.0, 0.0, 0.5 * math.pi, rng.uniform(0.0, 2.0 * math.pi)])
    if rng.random() < 0.6:
        draft.add(blank.moved(turn, rng.uniform(-50, 300), rng.uniform(-50, 300)))
        return
    x0, y0, x1, y1 = blank.bounds
    space = rng.choice([0.0, 3.0, 7.0, 10.0])
    columns = max(1, min(rng.randint(1, 3), int(1200.0 / (x1 - x0 + space))))
    rows = max(1, min(rng.randint(1, 2), int(850.0 / (y1 - y0 + space))))
    places = []
    for row in range(rows):
        for column in range(columns):
            x, y = column * (x1 - x0 + space) - x0, row * (y1 - y0 + space) - y0
            if (row + column) % 2 and rng.random() < 0.5:
                # Turned by 180° inside the same rectangle.
                places.append((math.pi, x + x0 + x1, y + y0 + y1))
            else:
                places.append((0.0, x, y))
    if rng.random() < 0.4:
        draft.add_copies(blank, places)
        return
    for around, x, y in places:
        draft.add(blank.moved(around, x, y))
