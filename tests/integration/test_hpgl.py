"""HPGL from drawing to verdict: accepted, refused if damaged, and read alike by another program."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from ezdxf.addons.hpgl2.backend import Recorder
from ezdxf.addons.hpgl2.interpreter import Interpreter
from ezdxf.addons.hpgl2.plotter import Plotter
from ezdxf.addons.hpgl2.tokenizer import hpgl2_commands

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.pipeline import Compiled
from knifetip.verification.reading.hpgl import READER
from tests.support.drawings import drawing
from tests.support.programs.mixed_carton import mixed_carton
from tests.support.shapes import closed, dieline

MACHINE, BOARD = load.machine("flat-cutter-hpgl"), load.board("fbb-0.4")
Made = tuple[Dieline, Compiled]
#: A turn by 5.4°, for rows of points.
TURN = np.array([[np.cos(0.0942), np.sin(0.0942)], [-np.sin(0.0942), np.cos(0.0942)]])


def compiled(data: bytes) -> Made:
    drawing = pipeline.read(data)
    dieline = pipeline.classify(drawing, load.profile("default"))
    return dieline, pipeline.compile(drawing, dieline, MACHINE, BOARD)


@pytest.fixture(scope="module")
def made() -> Made:
    return compiled(mixed_carton())


@pytest.mark.parametrize("name", ["tuck-end-carton.dxf", "corrugated-tray.dxf"])
def test_a_sample_is_accepted(name: str) -> None:
    _, result = compiled(samples()[name])
    assert {one.message.code for one in result.verdict.findings} == {"verify.blade-bend"}
    assert result.verdict.accepted
    # 0.01 mm plus half the diagonal of a plotter unit.
    assert result.verdict.tolerance == pytest.approx(0.01 + 0.0125 * 2**0.5)
    assert 0.005 < result.verdict.deviation.max() < 0.0125 * 2**0.5 + 0.005


def test_every_line_type_of_a_knife_and_a_creasing_tool_is_accepted(made: Made) -> None:
    dieline, result = made
    kinds = {LineType(int(kind)) for kind in dieline.line_type}
    assert kinds == {LineType.CUT, LineType.CREASE, LineType.HALF_CUT, LineType.PERFORATION}
    assert result.verdict.accepted, result.verdict.findings
    assert result.verdict.seconds > 0.0
    pens = re.findall(rb"SP(\d);", result.program.text)
    # Creases, then partial cuts, then cuts through the board; last, the tool is put away.
    assert pens == [b"2", b"3", b"1", b"0"]


@pytest.mark.parametrize(
    ("corners", "bulges"),
    [
        # A slot of 0.4 mm: units of the plotter turn its floor by up to 2°.
        (((30.4, 80), (30.4, 60), (30, 60), (30, 80)), ()),
        # Two arcs that meet in a notch: chords of the path turn from their tangents.
        (((70, 80), (50, 70), (30, 80)), (0.0, 0.3, 0.3)),
    ],
)
def test_a_contour_is_one_run_although_a_notch_interrupts_it(
    corners: tuple[tuple[float, float], ...], bulges: tuple[float, ...]
) -> None:
    outline = closed((0, 80), (0, 0), (100, 0), (100, 80), *corners)
    dieline_of = dieline((LineType.CUT, outline), bulge={4 + i: b for i, b in enumerate(bulges)})
    turned = replace(dieline_of, ends=dieline_of.ends @ TURN)
    lines = drawing(turned.ends, [("CUT", 7, "CONTINUOUS")] * len(turned), bulge=turned.bulge)
    made = pipeline.compile(lines, turned, MACHINE, BOARD)
    # The slot is as narrow as the board is thick, and the blade turns in the arcs.
    assert {one.kind for one in made.verdict.findings} <= {"near", "beside"}
    assert made.verdict.accepted


@pytest.mark.parametrize("count", [24, 36, 48])
def test_holes_of_chords_shorter_than_a_unit_of_the_plotter_are_accepted(count: int) -> None:
    """The chords are drawn with two decimals, so they turn by up to 90°, and some of them are lost
    in the units of 0.025 mm."""
    outline = closed((0, 0), (400, 0), (400, 200), (0, 200))
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    holes = []
    for k in range(60):
        radius, x, y = 0.25 + 0.005 * k, 20.012 + 31.37 * (k % 12), 20.0 + 36.73 * (k // 12)
        points = np.stack([x + radius * np.cos(angle), y + radius * np.sin(angle)], axis=1)
        holes.append(closed(*(tuple(point) for point in np.round(points, 2).tolist())))
    drawn = dieline((LineType.CUT, np.concatenate([outline, *holes])))
    lines = drawing(drawn.ends, [("CUT", 7, "CONTINUOUS")] * len(drawn))
    made = pipeline.compile(lines, drawn, MACHINE, BOARD)
    assert {one.kind for one in made.verdict.findings} <= {"near", "beside"}
    assert made.verdict.accepted


def _nth(text: bytes, pattern: bytes, new: bytes, which: int = 0) -> bytes:
    found = list(re.finditer(pattern, text))[which]
    return text[: found.start()] + new + text[found.end() :]


def _shifted(text: bytes, x: int, y: int) -> bytes:
    return re.sub(
        rb"(P[UD])(-?\d+),(-?\d+)",
        lambda m: b"%s%d,%d" % (m[1], int(m[2]) + x, int(m[3]) + y),
        text,
    )


BREAKS: dict[str, Callable[[bytes], bytes]] = {
    "another pen": lambda text: text.replace(b"SP2;\nFS24;", b"SP1;\nFS30;"),
    "pens exchanged": lambda text: (
        text.replace(b"SP1;\nFS30;", b"SPx;").replace(b"SP3;\nFS12;", b"SP1;\nFS30;")
        .replace(b"SPx;", b"SP3;\nFS12;")
    ),
    "another force": lambda text: text.replace(b"FS12;", b"FS30;"),
    "another speed": lambda text: text.replace(b"VS30;", b"VS40;"),
    "no pen up before a travel": lambda text: _nth(text, rb"PU;\nPU(?=\d)", b"PD", 4),
    "travel at work": lambda text: _nth(text, rb"PU(?=\d+,)", b"PD", 5),
    "a travel without pen up": lambda text: _nth(text, rb"PU;\nPU(?=\d)", b"PA", 0),
    "a lift left out": lambda text: _nth(text, rb"PU;\nPU\d+,\d+;\nPD;\n", b"", 6),
    "all shifted by two units": lambda text: _shifted(text, 2, 0),
    "all shifted up by two units": lambda text: _shifted(text, 0, -2),
    "out of bounds": lambda text: _nth(text, rb"PD\d+,", b"PD99999,", 3),
    "a move left out": lambda text: _nth(text, rb"PD\d+,\d+;\n", b"", 60),
    "a cut left out": lambda text: _nth(text, rb"PD;\n(PD\d+,\d+;\n)+PU;\n", b"", 8),
    "a part freed first": lambda text: _outline_first(text),
    "one cut twice as far": lambda text: _nth(text, rb"PU;\nSP0;", b"PD;PD100,100;PU;SP0;"),
    "relative coordinates": lambda text: text.replace(b"PA;", b"PR;"),
    "scaled coordinates": lambda text: text.replace(b"PA;", b"PA;SC0,1,0,1;"),
    "no semicolon": lambda text: _nth(text, rb"(?<=PD;\n)PD", b"PD1", 2),
}  # fmt: skip


def _outline_first(text: bytes) -> bytes:
    """Return the HPGL program with the cuts moved before the creases."""
    head, rest = text.split(b"PU;\nSP2;", 1)
    first, last = rest.rsplit(b"PU;\nSP1;", 1)
    cuts, end = last.rsplit(b"PU;\nSP0;", 1)
    return head + b"PU;\nSP1;" + cuts + b"PU;\nSP2;" + first + b"PU;\nSP0;" + end


@pytest.mark.parametrize("name", BREAKS)
def test_a_broken_program_is_refused(made: Made, name: str) -> None:
    dieline, result = made
    text = BREAKS[name](result.program.text)
    assert text != result.program.text
    verdict = pipeline.verify(text, dieline, result.placement, MACHINE, BOARD)
    assert not verdict.accepted


def test_every_displaced_point_is_refused(made: Made) -> None:
    dieline, result = made
    text = result.program.text
    points = list(re.finditer(rb"P([UD])(\d+),(\d+)", text))
    place = np.array([(int(point[2]), int(point[3])) for point in points])
    working = np.flatnonzero([point[1] == b"D" for point in points])
    for row in np.random.default_rng(1).choice(working, 40, replace=False):
        way = place[row] - place[row - 1]
        # A tenth of a millimetre to the left of the direction of travel.
        x, y = place[row] + np.rint(4.0 * np.array([-way[1], way[0]]) / np.hypot(*way)).astype(int)
        moved = text[: points[row].start()] + b"PD%d,%d" % (x, y) + text[points[row].end() :]
        verdict = pipeline.verify(moved, dieline, result.placement, MACHINE, BOARD)
        assert not verdict.accepted, (points[row][0], x, y)


def test_only_a_displacement_within_rounding_is_accepted(made: Made) -> None:
    dieline, result = made
    refused = [
        not pipeline.verify(
            _shifted(result.program.text, units, 0), dieline, result.placement, MACHINE, BOARD
        ).accepted
        for units in (-2, 0, 2)
    ]
    assert refused == [True, False, True]


def test_another_program_reads_the_same_lines_with_the_same_pens(made: Made) -> None:
    _, result = made
    moves, faults = READER.read(result.program.text, MACHINE, BOARD)
    assert faults == []
    # The other program reads HPGL/2 only, which starts with an escape sequence; it has no device,
    # speeds or forces.
    recorder = Recorder()
    foreign = Interpreter(Plotter(recorder))
    foreign.run(hpgl2_commands(b"\x1b%1B" + result.program.text))
    assert foreign.errors == []
    assert foreign.not_implemented_commands == {"IN", "VS", "FS"}
    seen = []
    for _, properties, line in recorder.player().recordings():
        points = np.array([(point.x, point.y) for point in line.vertices()])
        seen += [(properties.pen_index, *a, *b) for a, b in pairwise(points)]
    work = (moves.code > 0) & (moves.start[:, 2] == moves.end[:, 2])
    pens = np.array([1, 2])[moves.station[work]]
    half = np.isclose(moves.end[work, 2], BOARD.caliper - BOARD.half_cut_depth)
    ours = np.column_stack(
        [np.where(half, 3, pens), moves.start[work, :2] * 40, moves.end[work, :2] * 40]
    )
    np.testing.assert_allclose(np.array(seen), ours, atol=1e-6)
