"""Programs that make the rest of a sheet, and their earlier programs, as subjects of the attack."""

from __future__ import annotations

from dataclasses import replace

from knifetip import pipeline
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.sequencing.tracks import RestChoice, find_tracks, row_lines
from tests.attack.subjects import Subject
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

CUT, CREASE = LineType.CUT, LineType.CREASE
_CUTS = [
    (CUT, closed((0, 0), (120, 0), (120, 80), (0, 80))),
    (CUT, closed((40, 20), (80, 20), (80, 60), (40, 60))),
    (CUT, closed((150, 0), (200, 0), (200, 80), (150, 80))),
]
#: Two parts, the first with a window.
BLANKS = dieline(*_CUTS)
#: The same with a crease in each part.
TRAYS = dieline(*_CUTS, (CREASE, edges(((20, 0), (20, 80)), ((175, 0), (175, 80)))))
#: Machine, its language, and the drawing.
_JOBS = [
    ("demo-table", "linuxcnc", TRAYS),
    ("demo-table", "grblhal", TRAYS),
    ("two-carriage-table", "linuxcnc", TRAYS),
    ("router-table", "linuxcnc", BLANKS),
    ("laser-table", "grblhal", BLANKS),
    ("flat-cutter-hpgl", "hpgl", TRAYS),
]


def rests() -> list[Subject]:
    """Return rests of programs: the second half, and the last outline made again."""
    return [
        _rest(machine, language, line, again=again)
        for machine, language, line in _JOBS
        for again in (False, True)
    ]


def _rest(name: str, language: str, line: Dieline, *, again: bool) -> Subject:
    """Return a rest of a program as a subject.

    Parameters
    ----------
    name, language
        Name of the machine, and the language of its controller.
    line
        The drawing.
    again
        Whether the whole program was executed, and its last track is made again.
    """
    machine, board = with_language(load.machine(name), language), load.board("e-flute")
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    made = pipeline.compile(lines, line, machine, board)
    tracks = find_tracks(made.toolpath, row_lines(made.program, len(made.toolpath)))
    first = len(tracks) if again else len(tracks) // 2 + 1
    executed = len(made.program) if again else int(tracks.first_line[first - 1])
    left = pipeline.rest_of(made, RestChoice(from_track=first), executed)
    rest = pipeline.compile_rest(lines, line, machine, board, left)
    subject = Subject(
        f"rest {'again' if again else 'half'}, {name}, {language}",
        rest.program.text,
        line,
        rest.placement,
        machine,
        board,
    )
    return replace(subject, earlier=tuple(left.earlier))
