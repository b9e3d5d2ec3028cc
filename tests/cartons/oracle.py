"""Check accepted programs without the verifier, by the tests' own controllers and LinuxCNC's
interpreter.

The program must do nothing dangerous, and each tip must work only on drawn lines: a knife or a
wheel within 0.01 mm of one, a V-cutter also beyond its ends, and a router or laser at its radius.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import shapely

from knifetip.geometry.columns import F64
from knifetip.languages.registry import with_language
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Laser, VCutter
from tests.attack.controller import NotExecuted
from tests.attack.damage import Oracle, interpreter_difference
from tests.attack.effects import Contact
from tests.attack.subjects import Subject
from tests.cartons.job import Job
from tests.cartons.trial import Outcome
from tests.controllers.linuxcnc_rs274 import RS274
from tests.support.programs.line_mutation import chords

#: Greatest distance of a tip from a drawn line (mm): the tolerance, the rounding of a plotter, and
#: the displacement of ends by cleaning.
_TOLERANCE: Final = 0.01 + 0.0177 + 0.05
#: Line types that each kind of tool makes.
_MAKES: Final = {
    Knife: (LineType.CUT, LineType.PERFORATION, LineType.HALF_CUT, LineType.COMBI),
    CreaseWheel: (LineType.CREASE, LineType.COMBI),
    VCutter: (LineType.V_GROOVE,),
    Cutter: (LineType.CUT,),
    Laser: (LineType.CUT,),
}


def check_tip_path(_job: Job, outcome: Outcome) -> str:
    """Return what is wrong with the accepted program of a job, "" if nothing."""
    attempt, compiled = outcome.attempt, outcome.compiled
    assert attempt is not None
    assert compiled is not None
    machine = with_language(attempt.machine, attempt.dialect)
    text = compiled.program.text
    oracle = Oracle(Subject("", text, attempt.dieline, compiled.placement, machine, attempt.board))
    try:
        effect = oracle.effect_of(text)
    except NotExecuted as fault:
        return f"not executed: {fault}"
    # The effects do not take the size of the sheet into account, so low moves beside it would count
    # as dangers.
    on_table = attempt.options.sheet is None
    if attempt.options.lift == "clearance" and on_table and effect.dangers:
        return effect.dangers[0]
    if RS274 and machine.dialect == "linuxcnc":
        difference = interpreter_difference(oracle.run_of(text), text, machine)
        if difference:
            return difference
    # The effects count the stations in the order of the machine for this board.
    for index, held in enumerate(oracle.machine.stations if on_table else ()):
        own = [
            each
            for each in effect.contacts
            if each.station == (held.number if oracle.plots else index)
        ]
        if not own:
            continue
        kinds = _MAKES[type(held.tool)]
        far, where = _farthest(own, _drawn(outcome, kinds))
        limit = _TOLERANCE
        if isinstance(held.tool, VCutter):
            limit += attempt.board.groove_overcut + attempt.board.groove_shift + 0.1
        elif isinstance(held.tool, Cutter):
            limit += max(held.tool.lead_in, 2.0 * held.tool.radius) + held.tool.radius
        elif isinstance(held.tool, Laser):
            limit += held.tool.lead_in + held.tool.kerf
        elif isinstance(held.tool, Knife):
            # Beyond ends on cuts with waste behind them.
            limit += held.tool.lead(1.0) * attempt.board.caliper
        if far > limit:
            return f"{held.name} works {far:.3f} mm from all its lines at {where}"
    return ""


def _drawn(outcome: Outcome, kinds: tuple[LineType, ...]) -> F64:
    """Return the drawn lines of some types as chords on the sheet, (n, 2, 2) mm."""
    assert outcome.attempt is not None
    assert outcome.compiled is not None
    line = outcome.attempt.dieline
    found = [np.zeros((0, 2, 2))]
    for row in np.flatnonzero(np.isin(line.line_type, kinds)):
        way = chords(line.ends[row, 0], line.ends[row, 1], float(line.bulge[row]))
        found.append(np.stack([way[:-1], way[1:]], axis=1))
    lines: F64 = np.concatenate(found) + np.array(outcome.compiled.placement)
    return lines


def _farthest(contacts: list[Contact], lines: F64) -> tuple[float, tuple[float, float]]:
    """Return the greatest distance of points of contacts from lines (mm), and where it is."""
    points = np.concatenate([each.points[:, :2] for each in contacts])
    if not len(lines):
        return np.inf, (0.0, 0.0)
    tree = shapely.STRtree(shapely.linestrings(lines))
    spots = shapely.points(points)
    found, far = tree.query_nearest(spots, return_distance=True, all_matches=False)
    worst = int(far.argmax())
    x, y = points[found[0][worst]].round(3).tolist()
    return float(far[worst]), (x, y)
