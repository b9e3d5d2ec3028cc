"""Programs interpreted by LinuxCNC are accepted, and the tip follows the lines.

The toolpaths are those of ``hand_written``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest

from knifetip.model.dieline import LineType
from knifetip.model.toolpath import Motion
from knifetip.post.emit import process
from tests.controllers.hand_written import (
    BLANK,
    CREASES,
    GROOVE,
    JOBS,
    KNIFE,
    TABLE,
    TOOLS,
    V_CUTTER,
    Edges,
    ToolpathBuilder,
    add_creases,
    add_cuts,
    add_groove,
    concatenate_edges,
)
from tests.controllers.linuxcnc_rs274 import (
    ABSENT,
    ARC,
    RS274,
    Report,
    TipTool,
    read_program,
    verify_by_interpreter,
)

pytestmark = [
    pytest.mark.controller,
    pytest.mark.skipif(RS274 is None, reason=ABSENT),
]


def verdict(
    program: bytes,
    edges: Edges,
    tools: Mapping[int, TipTool] = TOOLS,
    placement: tuple[float, float] = (20.0, 20.0),
) -> Report:
    ends, bulge, line_type = edges
    return verify_by_interpreter(program, ends, bulge, line_type, placement, tools)


@pytest.mark.parametrize("job", JOBS)
def test_the_tip_of_each_tool_is_on_the_line(job: str) -> None:
    write, dieline = JOBS[job]
    report = verdict(write(ToolpathBuilder()).program(), dieline)
    assert report.accepted, report.stderr
    assert report.problems == []
    assert report.worst_deviation <= 2e-4
    assert report.worst_gap <= 2e-4
    assert report.worst_overrun <= 1e-4
    assert report.worst_heading <= 1e-3
    expected = {"knife": 90 + 40 + 90 + 60 + 10 * np.pi, "wheel": 2 * 52.2, "v-cutter": 40.0}
    assert report.worked == pytest.approx(expected[job], abs=0.01)


def test_three_stations_in_one_program_work_with_their_own_datum_and_piston() -> None:
    program = add_cuts(add_groove(add_creases(ToolpathBuilder()))).program()
    report = verdict(program, concatenate_edges(BLANK, CREASES, GROOVE))
    assert report.problems == []
    assert max(report.worst_deviation, report.worst_gap) <= 2e-4
    assert report.worst_heading <= 1e-3


@pytest.mark.parametrize(
    ("old", "new", "measure", "least"),
    [
        (b"G1 X210.0000", b"G1 X210.0300", "worst_deviation", 0.02),
        (b"G1 Y120.0000", b"G1 Y120.2000", "accepted", None),
        (b"J10.0000\n", b"J10.0200\n", "worst_deviation", 0.004),
        (b"C180.0000 I-10", b"C181.0000 I-10", "worst_heading", 0.5),
        (b"C90.0000 I0.0000", b"C-90.0000 I0.0000", "worst_heading", 90.0),
        (b"G1 X120.0000\n", b"G1 X140.0000\n", "worst_deviation", 10.0),
        (b"G3 X220.0000 Y80.0000 C90.0000 I0.0000 J10.0000", b"G1 X220 Y80 C90", "worst_gap", 2.9),
        (b"M64 P0", b"M64 P1", "problems", None),
        (b"M3 S1", b"M5", "problems", None),
        (b"T1 M6 G43", b"T1 M6", "problems", None),
        (b"G1 Z-0.3000", b"G0 Z-0.3000", "problems", None),
        (b"G1 Z-0.3000", b"G1 Z0.3000", "worst_gap", 10.0),
        (b"G3 X210.0000", b"G3 X210.0O00", "accepted", None),
        (b"J10.0000", b"", "accepted", None),
        (b"F12000\n", b"\n", "accepted", None),
    ],
)
def test_the_second_verifier_finds_errors(
    old: bytes, new: bytes, measure: str, least: float | None
) -> None:
    program = add_cuts(ToolpathBuilder()).program()
    shifted = {1: replace(KNIFE, datum=(7.0, 0.0, 0.0, 0.0))} if b"T1" in old else TOOLS
    assert not verdict(program, BLANK, shifted).problems
    assert old in program
    report = verdict(program.replace(old, new, 1), BLANK, shifted)
    if least is not None:
        assert getattr(report, measure) > least
    elif measure == "accepted":
        assert not report.accepted
        assert report.stderr
    else:
        assert report.problems


def test_the_second_verifier_finds_an_edge_that_is_not_cut_and_a_cut_without_an_edge() -> None:
    program = add_cuts(ToolpathBuilder()).program()
    more = concatenate_edges(BLANK, ([((0, 0), (5, 0))], [0], [LineType.CUT]))
    assert verdict(program, more).worst_gap == pytest.approx(np.hypot(100, 50), abs=0.01)
    ends, bulge, kinds = BLANK
    assert verdict(program, (ends[1:], bulge[1:], kinds[1:])).worst_deviation > 40.0
    assert verdict(program, (*BLANK[:2], [LineType.CREASE] * 6)).worst_deviation == np.inf


def test_the_second_verifier_finds_a_v_cutter_on_the_wrong_side_and_one_that_tears_on_entry() -> (
    None
):
    program = add_groove(ToolpathBuilder()).program()
    mirrored = {3: replace(V_CUTTER, back=-6.0)}
    assert verdict(program, GROOVE, mirrored).worst_deviation > 11.9
    upright = program.replace(b"G0 X209.2000", b"G0 X206.0000")
    assert verdict(upright, GROOVE).worst_deviation > 1.0


def test_the_controller_reads_positions_and_arcs_within_the_last_decimal() -> None:
    """Two thousand moves of every size are accepted with coordinates within the last decimal."""
    rng = np.random.default_rng(12)
    builder = ToolpathBuilder().to(1, Motion.RAPID, 500, 500, 20, 0)
    x, y, c = 500.0, 500.0, 0.0
    for _ in range(2000):
        step = 10.0 ** rng.uniform(-5, 2.5)
        angle = rng.uniform(0, 2 * np.pi)
        x, y = x + step * np.cos(angle), y + step * np.sin(angle)
        c = np.clip(c + rng.normal() * 30, -1000, 1000)
        bulge = rng.choice([0.0, rng.uniform(-1, 1), 10 ** rng.uniform(-7, 0), -1.0, 1.0])
        speed = 10.0 ** rng.uniform(2, 4.8)
        builder.to(1, Motion.FEED, x, y, rng.choice([-0.3, 1.2]), c, bulge, speed)
    path = builder.toolpath()
    program = process(path, TABLE, "linuxcnc")
    reading = read_program(program.text, TOOLS)
    assert reading.accepted, reading.stderr
    sent = program.source[[b"G64" not in line and line[:1] == b"G" for line in program.lines()]]
    rows = sent[sent >= 0]
    # The moves of rs274: the first lift, those of the toolpath, the last lift.
    ends = reading.moves.end[1:-1]
    assert len(ends) == len(rows) > 1900
    whole = np.append(rows[1:] != rows[:-1], True)
    assert np.abs(ends - path.pose[rows + 1])[whole].max() < 0.51e-4 + 1e-9
    curved = reading.moves.kind[1:-1] == ARC
    assert curved.sum() > 800
    arcs = reading.moves.start[1:-1][curved, :2] - reading.moves.centre[1:-1][curved]
    others = reading.moves.end[1:-1][curved, :2] - reading.moves.centre[1:-1][curved]
    assert np.abs(np.hypot(*arcs.T) - np.hypot(*others.T)).max() < 3e-4


def test_feeds_equal_those_of_the_toolpath() -> None:
    builder = add_cuts(ToolpathBuilder())
    moves = read_program(builder.program(), TOOLS).moves
    working = moves.kind != 0
    # rs274 converts inverse time back to a feed: 90 degrees at 72,000 per minute.
    swivel = working & (moves.start[:, :3] == moves.end[:, :3]).all(axis=1)
    np.testing.assert_allclose(moves.feed[swivel], [72000.0])
    np.testing.assert_allclose(moves.feed[working & ~swivel], 12000.0)


def test_commands_in_comments_are_not_written_for_linuxcnc() -> None:
    builder = ToolpathBuilder().to(1, Motion.RAPID, 1, 1)
    text = process(
        builder.toolpath(), TABLE, "linuxcnc", notes=["(PY,raise SystemExit(7))", "LOGOPEN,x.txt"]
    ).text
    assert read_program(text, TOOLS).accepted
    spoken = read_program(
        text.replace(b"(PY raise", b"(PY,raise").replace(b"SystemExit 7", b"x"), TOOLS
    )
    assert not spoken.accepted
