"""The last of the cuts that release a piece of board together is a short one."""

from __future__ import annotations

import numpy as np
import pytest

from knifetip import compensate, plan, sequence
from knifetip.geometry.columns import F64, I64
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.planning.cut_sides import cut_sides
from knifetip.planning.last_cuts import LONG, releasing_cuts, track_levels
from knifetip.planning.layers import cut_layers
from tests.support.shapes import dieline, edges

LASER = load.machine("laser-table")
KNIFE = load.machine("demo-table")
BOARD = load.board("fbb-0.4")


def levels(*cuts: F64) -> list[int]:
    """Return the level of each cut, if each cut is one track."""
    ends = np.concatenate(cuts)
    straight = np.zeros(len(ends))
    found = cut_layers(ends, straight, cut_sides(ends, straight).face)
    length = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    tracks: I64 = np.arange(len(ends))
    found_levels: list[int] = track_levels(found.number, found.stretches, tracks, length).tolist()
    return found_levels


def crossing(x: tuple[float, ...], y: tuple[float, ...], wide: float, high: float) -> F64:
    """Return upright lines at ``x`` of length ``high``, and level lines at ``y`` of length
    ``wide``; they begin 5 mm to the left of and below the first corner.
    """
    return edges(
        *(((at, y[0] - 5), (at, y[0] - 5 + high)) for at in x),
        *(((x[0] - 5, at), (x[0] - 5 + wide, at)) for at in y),
    )


def test_one_of_the_short_lines_round_a_piece_comes_after_the_long_ones() -> None:
    assert levels(crossing((0, 200), (0, 60), 210, 100)) == [0, 1, 0, 0]


def test_lines_of_similar_length_have_no_order() -> None:
    assert levels(crossing((0, 130), (0, 90), 140, 100)) == [0, 0, 0, 0]
    assert levels(crossing((0, 145), (0, 90), 155, 100)) == [0, 1, 0, 0]


def test_a_line_that_is_short_for_one_piece_and_long_for_another_is_between() -> None:
    # The upright line on the right is the shortest one round the upper piece.  The lower piece has
    # a shorter one on its left.
    cuts = edges(
        ((0, -5), (0, 115)), ((-30, -5), (-30, 50)), ((-290, 40), (-290, 340)),
        ((-295, 110), (5, 110)), ((-295, 50), (5, 50)), ((-295, 0), (5, 0)),
    )  # fmt: skip
    assert levels(cuts) == [1, 2, 0, 0, 0, 0]


def test_a_slit_in_the_piece_does_not_count() -> None:
    slit = edges(((50, 30), (60, 30)))
    assert levels(crossing((0, 200), (0, 60), 210, 100), slit) == [0, 1, 0, 0, 0]


def test_no_cuts_have_no_levels() -> None:
    assert levels(np.zeros((0, 2, 2))) == []


@pytest.mark.parametrize("machine", [KNIFE, LASER], ids=lambda machine: machine.name)
def test_blanks_with_nicks_are_released_by_a_short_cut(machine: Machine) -> None:
    chance = np.random.default_rng(5)
    blanks, size = [], []
    for number in range(24):
        corners = 3 + number % 4
        turn = np.sort(chance.uniform(0.0, 2.0 * np.pi / corners, corners)) * 0.6
        angle = 2.0 * np.pi / corners * np.arange(corners) + turn
        middle = np.array([100.0 + 90.0 * (number % 6), 100.0 + 90.0 * (number // 6)])
        points = middle + 40.0 * np.column_stack([np.cos(angle), np.sin(angle)])
        sides = np.stack([points, np.roll(points, -1, axis=0)], axis=1)
        length = np.hypot(*(sides[:, 1] - sides[:, 0]).T)
        ahead = (sides[:, 1] - sides[:, 0]) / length[:, None]
        # Nicks of 0.7 mm or more at the corners make a track of each side.
        sides[:, 0] += 0.5 * ahead
        sides[:, 1] -= 0.5 * ahead
        blanks.append((LineType.CUT, sides))
        size.append(length - 1.0)
    line = dieline(*blanks)
    toolpath = sequence([compensate(one) for one in plan(line, machine, BOARD)], machine)
    first = np.concatenate([[0], np.cumsum([len(one) for one in size])])
    place = np.array([np.flatnonzero(toolpath.source == row).max() for row in range(first[-1])])
    different = 0
    for begin, end, length in zip(first[:-1], first[1:], size, strict=True):
        last = length[place[begin:end].argmax()]
        assert last <= LONG * length.min() + 1e-9
        different += length.max() > LONG * length.min()
    assert different >= 12, "in half of the blanks the order is not free"


def test_a_cut_between_two_loose_pieces_releases_none() -> None:
    # A square, and to the right of it a rectangle that shares the line 0.
    shared = edges(((10, 0), (10, 10)))
    square = edges(((10, 0), (0, 0)), ((0, 0), (0, 10)), ((0, 10), (10, 10)))
    rectangle = edges(((10, 0), (40, 0)), ((40, 0), (40, 10)), ((40, 10), (10, 10)))
    ends = np.concatenate([shared, square, rectangle])
    found = cut_layers(ends, np.zeros(7), np.full(7, -1))
    rank: I64 = np.array([0, 0, 0, 0, 1, 1, 1])
    assert releasing_cuts(rank, found.stretches).tolist() == [False] + [True] * 3 + [False] * 3
    # If the rectangle is cut later, the sheet still holds it.
    assert releasing_cuts(-rank, found.stretches)[:4].tolist() == [True] * 4
