"""Programs that make the rest of a sheet, in every controller language and with every machine."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.job_options import JobOptions
from knifetip.model.machine import Machine
from knifetip.model.sheet import Sheet
from knifetip.model.toolpath import Motion
from knifetip.pipeline import Compiled
from knifetip.sequencing.tracks import RestChoice, Tracks, find_tracks, row_lines
from knifetip.verification.verify import trace_program
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

CUT, CREASE, GROOVE = LineType.CUT, LineType.CREASE, LineType.V_GROOVE
#: Two trays with creases, a window in the first, and slits.
TRAYS = dieline(
    (CUT, closed((0, 0), (200, 0), (200, 120), (0, 120))),
    (CUT, closed((60, 40), (120, 40), (120, 80), (60, 80))),
    (CUT, closed((220, 0), (300, 0), (300, 120), (220, 120))),
    (CREASE, edges(((30, 0), (30, 120)), ((170, 0), (170, 120)), ((260, 0), (260, 120)))),
)
#: The same without creases, for machines that only mill or burn.
BLANKS = dieline(
    (CUT, closed((0, 0), (200, 0), (200, 120), (0, 120))),
    (CUT, closed((60, 40), (120, 40), (120, 80), (60, 80))),
    (CUT, closed((220, 0), (300, 0), (300, 120), (220, 120))),
)
MACHINES = [
    ("demo-table", "linuxcnc", "e-flute"),
    ("demo-table", "grblhal", "e-flute"),
    ("flat-cutter-hpgl", "hpgl", "e-flute"),
    ("two-carriage-table", "linuxcnc", "e-flute"),
    ("router-table", "linuxcnc", "e-flute"),
    ("laser-table", "grblhal", "e-flute"),
    ("v-groove-table", "mcx314", "e-flute"),
]
every_machine = pytest.mark.parametrize(("name", "language", "board"), MACHINES)


@cache
def job(
    name: str, language: str, board: str, sheet: bool = False
) -> tuple[Drawing, Dieline, Machine, Compiled]:
    machine = with_language(load.machine(name), language)
    line = BLANKS if name in ("router-table", "laser-table") else TRAYS
    lines = drawing(line.ends, [("0", 7, "CONTINUOUS")] * len(line), bulge=line.bulge)
    options = JobOptions(sheet=Sheet() if sheet else None)
    made = pipeline.compile(lines, line, machine, load.board(board), options=options)
    assert made.verdict.accepted
    return lines, line, machine, made


def tracks_of(compiled: Compiled) -> Tracks:
    return find_tracks(compiled.toolpath, row_lines(compiled.program, len(compiled.toolpath)))


def rest(
    name: str,
    language: str,
    board: str,
    choice: RestChoice,
    *,
    sheet: bool = False,
    earlier: tuple[EarlierWork, ...] | None = None,
    executed: int = 0,
) -> Compiled:
    """Return the rest of a program; ``earlier`` replaces the work that the verifier gets."""
    lines, line, machine, made = job(name, language, board, sheet)
    left = pipeline.rest_of(made, choice, executed)
    if earlier is not None:
        left = replace(left, earlier=earlier)
    options = JobOptions(sheet=Sheet() if sheet else None)
    return pipeline.compile_rest(lines, line, machine, load.board(board), left, options=options)


def refusals(compiled: Compiled) -> set[str]:
    return {found.message.code for found in compiled.verdict.findings if found.refuses}


@every_machine
@pytest.mark.parametrize("sheet", [False, True])
def test_the_rest_from_every_track_is_accepted(
    name: str, language: str, board: str, sheet: bool
) -> None:
    tracks = tracks_of(job(name, language, board, sheet)[3])
    for number in range(1, len(tracks) + 1):
        choice = RestChoice(from_track=number, made=True)
        found = rest(name, language, board, choice, sheet=sheet)
        assert refusals(found) == set()
        assert len(tracks_of(found)) == len(tracks) - number + 1


@every_machine
def test_the_whole_as_a_rest_follows_the_same_path(name: str, language: str, board: str) -> None:
    _, _, machine, made = job(name, language, board)
    again = rest(name, language, board, RestChoice(from_track=1, made=True))
    one, other = (
        trace_program(each.program.text, machine, load.board(board))[2] for each in (made, again)
    )
    np.testing.assert_array_equal(one.curve, other.curve)
    np.testing.assert_array_equal(one.heading, other.heading)
    np.testing.assert_array_equal(one.z, other.z)


@every_machine
def test_a_rest_with_a_missing_track_is_refused(name: str, language: str, board: str) -> None:
    made = job(name, language, board)[3]
    tracks = tracks_of(made)
    last = len(tracks) - 1
    lines = ((int(tracks.first_line[0]), int(tracks.last_line[last - 2])),)
    found = rest(
        name,
        language,
        board,
        RestChoice(from_track=last + 1, made=True),
        earlier=(EarlierWork(made.program.text, lines),),
    )
    assert refusals(found) & {"verify.not-worked", "verify.contour-unreached"}


@every_machine
def test_a_rest_that_makes_a_track_twice_is_refused(name: str, language: str, board: str) -> None:
    made = job(name, language, board)[3]
    tracks = tracks_of(made)
    middle = len(tracks) // 2
    lines = ((int(tracks.first_line[0]), int(tracks.last_line[middle])),)
    found = rest(
        name,
        language,
        board,
        RestChoice(from_track=middle + 1, made=True),
        earlier=(EarlierWork(made.program.text, lines),),
    )
    assert "verify.made-before" in refusals(found)
    repeated = [
        each for each in found.verdict.findings if each.message.code == "verify.made-before"
    ]
    own = tracks_of(found)
    # The knife lifts at corners, so a track of the planner may be several of the verifier.
    assert all(own.first_line[0] <= each.line <= own.last_line[0] for each in repeated)


def test_creases_after_the_outline_of_an_earlier_program_are_refused() -> None:
    key = ("demo-table", "linuxcnc", "e-flute")
    wheel = int(tracks_of(job(*key)[3]).station[0])
    assert wheel != 1
    found = rest(*key, RestChoice(station=wheel, made=True))
    assert refusals(found) == {"verify.released-before"}
    # The other way round the creases are made, and the knife makes the rest.
    assert refusals(rest(*key, RestChoice(station=1, made=True))) == set()


#: Rows of the two outer contours in TRAYS and in BLANKS.
OUTLINES = {*range(4), *range(8, 12)}


@every_machine
def test_the_inside_of_a_part_is_not_made_again_after_its_outline(
    name: str, language: str, board: str
) -> None:
    made = job(name, language, board)[3]
    tracks, executed = tracks_of(made), len(made.program)
    path = made.toolpath
    inside = [
        not {*path.source[first : last + 1].tolist()} - {-1} <= OUTLINES
        for first, last in zip(tracks.first_row, tracks.last_row, strict=True)
    ]
    assert inside[0]
    assert not inside[-1]
    for number in range(1, len(tracks) + 1):
        choice = RestChoice(from_track=number)
        found = refusals(rest(name, language, board, choice, executed=executed))
        assert found == ({"verify.released-before"} if any(inside[number - 1 :]) else set())
        # The operator has found that a blunt tool did not cut through.
        uncut = replace(choice, uncut=True)
        assert refusals(rest(name, language, board, uncut, executed=executed)) == set()


@every_machine
def test_a_rest_after_any_line_is_accepted(name: str, language: str, board: str) -> None:
    made = job(name, language, board)[3]
    last = int(tracks_of(made).last_line[-1])
    for executed in range(0, last, max(last // 15, 1)):
        found = rest(name, language, board, RestChoice(), executed=executed)
        assert refusals(found) == set(), executed


def test_a_rest_of_a_rest_includes_what_the_first_program_has_cut() -> None:
    key = ("demo-table", "linuxcnc", "e-flute")
    lines, line, machine, made = job(*key)
    board, count = load.board("e-flute"), len(tracks_of(made))
    # The outlines are made again, then the creases.
    left = pipeline.rest_of(made, RestChoice(from_track=count), len(made.program))
    first = pipeline.compile_rest(lines, line, machine, board, left)
    assert refusals(first) == set()
    again = pipeline.rest_of(first, RestChoice(from_track=1), 0)
    creases = replace(
        pipeline.rest_of(made, RestChoice(from_track=1), 0),
        earlier=(replace(left.earlier[0], lines=()), *again.earlier),
    )
    assert "verify.released-before" in refusals(
        pipeline.compile_rest(lines, line, machine, board, creases)
    )


def test_a_rest_from_the_middle_of_a_contour_begins_at_its_start() -> None:
    key = ("demo-table", "linuxcnc", "e-flute")
    made = job(*key)[3]
    tracks = tracks_of(made)
    number = len(tracks) - 1
    middle = int(tracks.first_line[number] + tracks.last_line[number]) // 2
    assert tracks.first_line[number] < middle
    found = rest(*key, RestChoice(from_line=middle, made=True))
    assert refusals(found) == set()
    first = tracks_of(found).first_row[0]
    before = made.toolpath.pose[tracks.first_row[number]]
    np.testing.assert_array_equal(found.toolpath.pose[first], before)


def test_the_head_of_a_rest_establishes_the_state_of_the_machine() -> None:
    key = ("demo-table", "linuxcnc", "e-flute")
    _, _, machine, made = job(*key)
    found = rest(*key, RestChoice(from_track=len(tracks_of(made)), made=True))
    moves, poses, _ = trace_program(found.program.text, machine, load.board("e-flute"))
    first = int(np.flatnonzero(poses.inside)[0])
    # All stations were released before the one that works was lowered.
    assert moves.stated[first].all()
    assert (moves.end[:first, 2].max(), moves.code[:first].max()) == (20.0, 0)
    assert found.toolpath.motion[0] == Motion.RAPID
    assert found.toolpath.pose[0].tolist() == made.toolpath.pose[0].tolist()


def test_a_rest_of_a_rest_is_accepted_with_the_work_of_both_programs() -> None:
    key = ("demo-table", "grblhal", "e-flute")
    lines, line, machine, made = job(*key)
    left = pipeline.rest_of(made, RestChoice(from_track=3, made=True))
    first = pipeline.compile_rest(lines, line, machine, load.board("e-flute"), left)
    again = pipeline.rest_of(first, RestChoice(from_track=2, made=True))
    whole = replace(again, earlier=(*left.earlier, *again.earlier))
    board = load.board("e-flute")
    assert refusals(pipeline.compile_rest(lines, line, machine, board, whole)) == set()
    # The first program alone leaves its first two tracks unexplained.
    assert "verify.not-worked" in refusals(
        pipeline.compile_rest(lines, line, machine, board, again)
    )


def test_the_head_rises_over_a_track_that_is_left_out() -> None:
    key = ("demo-table", "linuxcnc", "e-flute")
    lines, line, machine, made = job(*key)
    tracks = tracks_of(made)
    assert tracks.station[0] == tracks.station[2]
    lines_of_second = ((int(tracks.first_line[1]), int(tracks.last_line[1])),)
    left = replace(
        pipeline.rest_of(made, RestChoice(from_track=1, made=True)),
        tracks=np.delete(np.arange(len(tracks)), 1),
        earlier=(EarlierWork(made.program.text, lines_of_second),),
    )
    found = pipeline.compile_rest(lines, line, machine, load.board("e-flute"), left)
    assert refusals(found) == set()
    own = tracks_of(found)
    between = found.toolpath.pose[own.last_row[0] + 1 : own.first_row[1] + 1]
    assert between[:, 2].max() == machine.travel_z
    # The tracks that follow one another are connected as in the whole program.
    following = found.toolpath.pose[own.last_row[1] + 1 : own.first_row[2] + 1]
    whole = made.toolpath.pose[tracks.last_row[2] + 1 : tracks.first_row[3] + 1]
    np.testing.assert_array_equal(following, whole)
