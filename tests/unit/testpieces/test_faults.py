"""Test pieces on simulated machines with a known fault: cut through the fault, measured, found.

Each piece is read from its file, planned and proven.  The measures are taken from the poses of the
compiled program with the fault, not from the formulas of the wizards.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.errors import PieceRefused
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.library.definition import Shelf
from knifetip.model.board import Deflection
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.model.tool import Cutter, VCutter
from knifetip.pipeline import Compiled
from knifetip.testpieces import (
    crease_depth,
    deflection,
    knife_depth,
    squareness,
    station_offset,
    v_cutter,
)
from knifetip.testpieces.crease_depth import CreaseDepthMeasures
from knifetip.testpieces.deflection import DeflectionMeasures
from knifetip.testpieces.file import piece_dxf
from knifetip.testpieces.knife_depth import KnifeDepthMeasures
from knifetip.testpieces.piece import Piece
from knifetip.testpieces.squareness import SquarenessMeasures
from knifetip.testpieces.station_offset import StationOffsetMeasures
from knifetip.testpieces.v_cutter import VCutterMeasures
from knifetip.testpieces.wizard import Bench, Figure


class Cut(NamedTuple):
    """A piece that was compiled, with the lines of its drawing."""

    made: Compiled
    line: Dieline
    piece: Piece

    def strokes(self, *rows: int) -> F64:
        """Return the poses of the head at both ends of the moves along lines, (k, 2, 4)."""
        path = self.made.toolpath
        moves = np.flatnonzero(np.isin(path.source, rows))
        both = np.stack([path.pose[moves], path.pose[moves + 1]], axis=1)
        level = np.abs(both[:, 0, 2] - both[:, 1, 2]) < 1e-6
        moved = np.hypot(*(both[:, 1, :2] - both[:, 0, :2]).T) > 1.0
        result: F64 = both[level & moved]
        return result


def bench_of(machine: str, board: str, number: int) -> Bench:
    """Return a station of a machine of the library with a board."""
    table = load.machine(machine)
    station = next(one for one in table.stations if one.number == number)
    return Bench(table, load.board(board), station)


def cut(bench: Bench, piece: Piece) -> Cut:
    """Read the file of a piece and compile it; the program must be accepted."""
    drawn = pipeline.read(piece_dxf(piece))
    line = pipeline.interpret(drawn, Interpretation())
    np.testing.assert_array_equal(line.line_type, piece.line_type)
    np.testing.assert_allclose(line.ends, piece.ends, atol=1e-6)
    options = JobOptions(cut_depths=piece.cut_depths, crease_depths=piece.crease_depths)
    made = pipeline.compile(drawn, line, bench.machine, bench.board, options=options)
    assert made.verdict.accepted, [one.text for one in made.verdict.findings if one.refuses]
    return Cut(made, line, piece)


def rows_of(piece: Piece, line_type: LineType) -> list[int]:
    return [row for row, line in enumerate(piece.lines) if line.line_type == line_type]


def values(figures: list[Figure]) -> dict[str, float]:
    return {figure.name: figure.after for figure in figures}


@pytest.mark.parametrize(("across", "along"), [(0.3, -0.2), (-0.25, 0.15), (0.0, 0.0)])
@pytest.mark.parametrize("board", ["greyboard-2.0", "e-flute"])
def test_the_offsets_of_a_v_cutter_are_found(board: str, across: float, along: float) -> None:
    bench = bench_of("demo-table", board, 3)
    tool = bench.station.tool
    assert isinstance(tool, VCutter)
    back, half = tool.back + across, tool.half_width + along  # the blade that is really mounted
    job = cut(bench, v_cutter.draw(bench))
    inner = rows_of(job.piece, LineType.V_GROOVE)[1]
    marks, reach = [], []
    for stroke in job.strokes(inner):
        c = np.radians(stroke[0, 3])
        ahead, left = np.array([np.cos(c), np.sin(c)]), np.array([-np.sin(c), np.cos(c)])
        tips = stroke[:, :2] + back * left - half * ahead
        marks.append((left, tips[0]))
        ends = [tip + share * ahead for tip in tips for share in (0.0, 2.0 * half)]
        along_x = [end[0] for end in ends]
        reach.append(max(along_x) - min(along_x))
    # The flank of each pass rises to the right of its tip; b is positive if board is left between.
    (left, first), (_, second) = marks[:2]
    gap = float((second - first) @ left)
    found = v_cutter.figures(bench, VCutterMeasures(gap=gap, cut_length=reach[0]))
    assert values(found) == pytest.approx({"back": back, "half-width": half}, abs=2e-3)
    assert [figure.path for figure in found] == [
        ("station", 2, "tool", "back"),
        ("station", 2, "tool", "half_width"),
    ]
    assert found[0].is_significant is (abs(across) > 0.1)


@pytest.mark.parametrize("deeper", [-0.22, -0.05, 0.0, 0.13, 0.4])
@pytest.mark.parametrize("board", ["fbb-0.5", "e-flute", "greyboard-3.0"])
def test_the_offset_in_z_of_a_knife_is_found(board: str, deeper: float) -> None:
    bench = bench_of("demo-table", board, 1)
    piece = knife_depth.draw(bench)
    job = cut(bench, piece)
    rows = [row for row, line in enumerate(piece.lines) if np.isfinite(line.depth)]
    heights = [float(job.strokes(row)[:, :, 2].min()) - deeper for row in rows]
    through = [number for number, height in enumerate(heights, 1) if height <= 1e-9]
    first = through[0] if through else 0
    measures = KnifeDepthMeasures(first_through=first)
    if first in (0, 1):
        with pytest.raises(PieceRefused, match="programmed by more than"):
            knife_depth.figures(bench, measures)
        assert abs(deeper) > 0.15
        return
    (found,) = knife_depth.figures(bench, measures)
    assert abs(found.after - (bench.station.z + deeper)) <= found.uncertainty + 1e-3
    assert found.uncertainty <= 0.051
    assert found.path == ("station", 0, "datum", "z")


def test_thinner_board_is_not_taken_for_a_deeper_knife() -> None:
    bench = bench_of("demo-table", "e-flute", 1)
    depth = knife_depth.depths(bench)
    thickness = bench.board.caliper - 0.2
    first = 1 + next(row for row, one in enumerate(depth) if one >= thickness)
    (found,) = knife_depth.figures(
        bench, KnifeDepthMeasures(first_through=first, caliper=thickness)
    )
    assert not found.is_significant


@pytest.mark.parametrize("board", ["fbb-0.5", "solid-1.0", "e-flute", "eb-flute"])
def test_the_depth_of_creases_is_the_middle_of_the_good_ones(board: str) -> None:
    bench = bench_of("sample-table", board, 1)
    wheel = bench.makes(LineType.CREASE)
    assert wheel is not None
    bench = replace(bench, station=wheel)
    piece = crease_depth.draw(bench)
    job = cut(bench, piece)
    creases = rows_of(piece, LineType.CREASE)
    caliper, count = bench.board.caliper, crease_depth.COUNT
    pressed = np.array([caliper - job.strokes(row)[:, :, 2].min() for row in creases])
    assert (np.diff(pressed.reshape(2, count)) > 0.0).all()
    # A board that folds well between two depths, other than those in its file.
    limits = {"along": (0.93, 1.17), "across": (0.66, 0.97)}
    measures: dict[str, int] = {}
    for name, own in zip(limits, pressed.reshape(2, count), strict=True):
        low, high = np.array(limits[name]) * getattr(bench.board, f"crease_{name}")
        good = 1 + np.flatnonzero((own >= low) & (own <= high))
        measures |= {f"{name}_first": int(good[0]), f"{name}_last": int(good[-1])}
    found = crease_depth.figures(bench, CreaseDepthMeasures(**measures))
    for figure, (low, high) in zip(found, limits.values(), strict=True):
        middle = figure.before * (low + high) / 2.0
        assert abs(figure.after - middle) <= figure.uncertainty
        # Each limit lies less than one step beyond a flap, so the middle is half a step exact.
        assert abs(figure.after - middle) <= 0.05 * figure.before + 2e-3
        assert figure.shelf is Shelf.BOARDS


def test_creases_run_along_and_across_the_grain() -> None:
    bench = bench_of("sample-table", "fbb-0.5", 2)
    turned = replace(bench, board=replace(bench.board, grain=30.0))
    piece = crease_depth.draw(turned)
    ends = piece.ends[rows_of(piece, LineType.CREASE)]
    along = np.degrees(np.arctan2(*(ends[:, 1] - ends[:, 0]).T[::-1])) % 180.0
    np.testing.assert_allclose(along, np.repeat([30.0, 120.0], crease_depth.COUNT), atol=1e-3)
    assert cut(turned, piece).made.verdict.accepted


@pytest.mark.parametrize("number", [2, 3])
@pytest.mark.parametrize("shift", [(0.3, -0.4), (-1.2, 0.1)])
def test_the_offset_of_a_station_is_found(number: int, shift: tuple[float, float]) -> None:
    bench = bench_of("demo-table", "e-flute", number)
    station = bench.station
    true = station.x + shift[0], station.y + shift[1]  # where the tool really is on the head
    piece = station_offset.draw(bench)
    job = cut(bench, piece)
    type_ = LineType.CREASE if number == 2 else LineType.V_GROOVE
    knife, own = rows_of(piece, LineType.CUT)[5:], rows_of(piece, type_)

    def middle(row: int, axis: int, error: float) -> float:
        poses = job.strokes(row)[:, :, axis]
        # The axis moves by programmed position and offset; the tool is its true offset behind.
        return float(np.mean(poses)) + error

    distances = []
    for axis in range(2):
        old = (station.x, station.y)[axis]
        error = old - true[axis]
        mark = middle(own[axis], axis, error)
        distances.append(mark - middle(knife[axis], axis, 0.0))
    measures = StationOffsetMeasures(distance_x=distances[0], distance_y=distances[1])
    found = station_offset.figures(bench, measures)
    assert [figure.after for figure in found] == pytest.approx(true, abs=2e-3)
    assert [figure.path[-1] for figure in found] == ["x", "y"]


@pytest.mark.parametrize("stored", [90.0, 89.85, 90.4])
@pytest.mark.parametrize(
    ("scale_x", "scale_y", "lean"), [(1.0, 1.0, 0.0), (1.002, 0.999, 0.2), (0.9985, 1.001, -0.15)]
)
def test_scale_and_angle_of_the_axes_are_found(
    scale_x: float, scale_y: float, lean: float, stored: float
) -> None:
    bench = bench_of("v-groove-table", "e-flute", 1)
    bench = replace(bench, machine=replace(bench.machine, squareness=stored))
    job = cut(bench, squareness.draw(bench))
    poses = job.strokes(0, 1, 2, 3)[:, :, :2].reshape(-1, 2)
    low, high = poses.min(axis=0), poses.max(axis=0)
    drawn = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    # Where the program, which corrects the stored angle, sends the axes.
    along = drawn[:, 1] / np.sin(np.radians(stored))
    sent = np.column_stack([drawn[:, 0] - along * np.cos(np.radians(stored)), along])
    # The Y axis leans by ``lean`` degrees towards X.
    axes = np.array(
        [[scale_x, 0.0], scale_y * np.array([np.sin(np.radians(lean)), np.cos(np.radians(lean))])]
    )
    corners = sent @ axes

    def between(one: int, other: int) -> float:
        return float(np.hypot(*(corners[other] - corners[one])))

    # The knife overruns no corner of its own outline by more than the reading.
    measures = SquarenessMeasures(
        width=between(0, 1),
        height=between(0, 3),
        diagonal_up=between(0, 2),
        diagonal_down=between(3, 1),
        reading=0.05,
    )
    found = squareness.figures(bench, measures)
    at = {figure.name: figure for figure in found}
    assert abs(at["scale-x"].after - scale_x) <= at["scale-x"].uncertainty
    assert abs(at["scale-y"].after - scale_y) <= at["scale-y"].uncertainty
    # The knife ends up to 0.05 mm within the outline, 0.0001 of its sides.
    assert at["angle"].after == pytest.approx(90.0 - lean, abs=1e-4)
    assert (at["angle"].before, at["angle"].path) == (stored, ("squareness",))
    assert at["angle"].shelf is Shelf.MACHINES
    assert at["angle"].uncertainty < 0.02
    pulses = {figure.name: figure for figure in squareness.with_pulses(found, {"x": 200.0})}
    # 500 mm of X are travelled by pulses that move 500 mm times the scale.
    assert pulses["pulses-x"].after * at["scale-x"].after == pytest.approx(200.0, rel=1e-8)
    assert "pulses-y" not in pulses


def test_a_right_rectangle_leaves_the_stored_angle_as_it_is() -> None:
    bench = bench_of("demo-table", "greyboard-2.0", 1)
    bench = replace(bench, machine=replace(bench.machine, squareness=89.7))
    diagonal = float(np.hypot(500.0, 400.0))
    measures = SquarenessMeasures(
        width=500.0, height=400.0, diagonal_up=diagonal, diagonal_down=diagonal
    )
    at = {figure.name: figure for figure in squareness.figures(bench, measures)}
    assert at["angle"].after == pytest.approx(89.7)
    assert not at["angle"].is_significant
    assert (at["scale-x"].after, at["scale-y"].after) == pytest.approx((1.0, 1.0))


def test_the_angle_of_a_gantry_with_several_carriages_is_only_shown() -> None:
    bench = bench_of("two-carriage-table", "greyboard-2.0", 1)
    measures = SquarenessMeasures(
        width=500.0, height=400.0, diagonal_up=641.0, diagonal_down=639.6125
    )
    at = {figure.name: figure for figure in squareness.figures(bench, measures)}
    assert (at["angle"].shelf, at["angle"].path) == (None, ())
    assert at["angle"].after < 89.9


def test_offsets_of_stations_are_corrected_along_the_axes() -> None:
    bench = bench_of("demo-table", "greyboard-2.0", 2)
    bench = replace(bench, machine=replace(bench.machine, squareness=89.0))
    found = station_offset.figures(bench, StationOffsetMeasures(distance_x=20.0, distance_y=22.0))
    # 2 mm along y of the sheet: 2 / sin 89° along Y, and X back by 2 cot 89°.
    old = bench.station
    assert [one.after - one.before for one in found] == pytest.approx([0.03491, -2.00030], abs=1e-5)
    assert [one.before for one in found] == [old.x, old.y]


@pytest.mark.parametrize("known", [0.0, 0.05])
def test_the_deflection_of_a_cutter_is_found(known: float) -> None:
    bench = bench_of("router-table", "greyboard-3.0", 4)
    name, tool = bench.station.name, bench.station.tool
    assert isinstance(tool, Cutter)
    board = replace(bench.board, deflection=(Deflection(name, known, known),) if known else ())
    bench = replace(bench, board=board)
    job = cut(bench, deflection.draw(bench))
    poses = job.strokes(0, 1, 2, 3)
    level = poses[:, :, 2].min()
    centre = poses[np.abs(poses[:, :, 2].max(axis=1) - level) < 1e-6][:, :, :2]
    true = np.array([0.08, 0.03])
    # The force pushes the cutter outwards; the part ends a radius inside its centre.
    # Leads and arcs round corners are short; a side may have two parts.
    span = np.abs(centre[:, 1] - centre[:, 0])
    sides = [
        np.ptp(centre[(span[:, axis] < 1e-6) & (span[:, 1 - axis] > 20.0)][:, 0, axis])
        for axis in range(2)
    ]
    size = np.array(sides) - 2.0 * tool.radius + 2.0 * true
    measures = DeflectionMeasures(width=float(size[0]), height=float(size[1]))
    found = deflection.figures(bench, measures)
    assert [figure.after for figure in found] == pytest.approx(true.tolist(), abs=2e-3)
    assert found[0].path == ("deflection", name, "x")
