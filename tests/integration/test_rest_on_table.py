"""A job stops in the middle of a track on the simulated table; the rest completes the drawing."""

from __future__ import annotations

from contextlib import aclosing

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl import driver
from knifetip.gateway.motion import Limits
from knifetip.gateway.stream import stream
from knifetip.geometry.columns import F64
from knifetip.languages.registry import with_language
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.tool import Knife
from knifetip.sequencing.tracks import RestChoice, find_tracks, row_lines
from knifetip.simulators.grbl import simulator
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

MACHINE = with_language(load.machine("demo-table"), "grblhal")
BOARD = load.board("e-flute")
TRAYS = dieline(
    (LineType.CUT, closed((0, 0), (160, 0), (160, 90), (0, 90))),
    (LineType.CUT, closed((180, 0), (260, 0), (260, 90), (180, 90))),
    (LineType.CREASE, edges(((30, 0), (30, 90)), ((130, 0), (130, 90)), ((220, 0), (220, 90)))),
)


async def run(program: bytes, last: int | None = None) -> tuple[F64, int]:
    """Run a program until it ends, or until a tool is in the board after a given line.

    The machine is then stopped, as by the operator.  Returns the recorded positions (time, x, y, z,
    c), (n, 5), and the number of lines that the table had reported as executed.
    """
    executed = 0
    async with await simulator.serve(MACHINE, speed=4.0, sample=0.002) as server:
        controller = await driver.dial(
            server.address, SafeState.from_machine(MACHINE), silence=0.4, poll=0.02
        )
        course = stream(program, controller, limits=Limits.from_machine(MACHINE), interval=0.01)
        async with aclosing(course):
            async for progress in course:
                executed = progress.executed
                if last is not None and executed >= last and progress.position[2] < BOARD.caliper:
                    await controller.stop()
                    break
        await controller.close()
        assert server.table.trace is not None
        return server.table.trace.samples(), executed


def worked_points(samples: F64) -> F64:
    """Return the positions of the head at which a tool was in the board, (n, 2) mm."""
    low = samples[samples[:, 3] < BOARD.caliper - 1e-6]
    return low[:, 1:3]


def covered_lengths(points: list[F64], placement: tuple[float, float]) -> F64:
    """Return the fraction of each edge along which the head was low, (n,).

    The edges are compared at points 1 mm apart, except 8 mm at their ends: tools begin later there.
    """
    heads = []
    for station in MACHINE.stations:
        if isinstance(station.tool, Knife):
            assert station.tool.trail == 0.0
        heads.append((station.x, station.y))
    found = []
    for first, last in TRAYS.ends + np.array(placement):
        length = float(np.hypot(*(last - first)))
        along = np.arange(8.0, length - 8.0, 1.0)[:, None] / length
        wanted = first + along * (last - first)
        near = np.zeros(len(wanted), np.bool_)
        for shift in heads:
            for group in points:
                gap = np.hypot(*(wanted[:, None] + shift - group[None]).transpose(2, 0, 1))
                near |= gap.min(axis=1, initial=np.inf) < 0.7
        found.append(near.mean())
    return np.array(found)


@pytest.mark.parametrize("share", [0.4, 0.8])
async def test_an_interrupted_job_and_its_rest_make_every_edge(share: float) -> None:
    lines = drawing(TRAYS.ends, [("0", 7, "CONTINUOUS")] * len(TRAYS))
    made = pipeline.compile(lines, TRAYS, MACHINE, BOARD)
    tracks = find_tracks(made.toolpath, row_lines(made.program, len(made.toolpath)))
    line = int(tracks.first_line[int(share * len(tracks))])
    before, executed = await run(made.program.text, line)
    states = tracks.states(executed)
    assert "begun" in states
    left = pipeline.rest_of(made, RestChoice(), executed)
    assert left.tracks.tolist() == [row for row, state in enumerate(states) if state != "cut"]
    rest = pipeline.compile_rest(lines, TRAYS, MACHINE, BOARD, left)
    assert rest.verdict.accepted
    after, executed = await run(rest.program.text)
    assert executed == len(rest.program)
    points = [worked_points(samples) for samples in (before, after)]
    assert (covered_lengths(points, made.placement) == 1.0).all()
    # Neither run alone makes the drawing.
    for alone in points:
        assert covered_lengths([alone], made.placement).min() < 1.0
