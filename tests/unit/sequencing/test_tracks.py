"""Tracks of a program, their states, and the choice of those that remain to be made."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from knifetip.errors import PlanError
from knifetip.model.toolpath import Motion
from knifetip.sequencing.tracks import RestChoice, Tracks, find_tracks, select_rest
from tests.support.shapes import toolpath

RAPID, PLUNGE, FEED = Motion.RAPID, Motion.PLUNGE, Motion.FEED
#: Five tracks: two of station 2, then two of station 1, then one of station 2.
TRACKS = Tracks(
    first_row=np.array([1, 5, 9, 13, 17]),
    last_row=np.array([3, 7, 11, 15, 19]),
    first_line=np.array([11, 21, 31, 41, 51]),
    last_line=np.array([15, 25, 35, 45, 55]),
    station=np.array([2, 2, 1, 1, 2]),
)


def chosen(executed: int, **choice: Any) -> tuple[list[int], tuple[tuple[int, int], ...]]:
    found = select_rest(TRACKS, executed, RestChoice(**choice))
    return found.tracks.tolist(), found.made_lines


def test_a_track_begins_after_the_line_of_the_move_before_it() -> None:
    path = toolpath(
        np.zeros((7, 4)),
        [(motion, 1.0, 1) for motion in (RAPID, PLUNGE, FEED, RAPID, PLUNGE, RAPID)],
        track=[-1, 0, 0, -1, 1, -1],
    )
    # Lines 6 and 9 command no move: they lower the tool.
    found = find_tracks(path, np.array([5, 7, 8, -1, 10, 12], np.int32))
    assert found.first_row.tolist() == [1, 4]
    assert found.last_row.tolist() == [2, 4]
    assert found.first_line.tolist() == [6, 9]
    assert found.last_line.tolist() == [8, 10]


def test_executed_lines_divide_the_tracks() -> None:
    assert TRACKS.states(0) == ["uncut"] * 5
    assert TRACKS.states(30) == ["cut", "cut", "uncut", "uncut", "uncut"]
    assert TRACKS.states(31) == ["cut", "cut", "begun", "uncut", "uncut"]
    assert TRACKS.states(35) == ["cut", "cut", "cut", "uncut", "uncut"]


def test_executed_lines_that_are_made_again() -> None:
    def repeated(executed: int, **choice: Any) -> tuple[tuple[int, int], ...]:
        found = select_rest(TRACKS, executed, RestChoice(**choice))
        return found.repeated_lines

    assert repeated(35) == ()
    assert repeated(33) == ((31, 33),)
    assert repeated(43, from_track=2) == ((21, 43),)
    assert repeated(43, station=2, made=True) == ((11, 25),)
    assert repeated(43, from_track=2, uncut=True) == ()


@pytest.mark.parametrize("line", [31, 33, 34])
def test_the_rest_begins_with_the_track_that_was_begun(line: int) -> None:
    assert chosen(line) == ([2, 3, 4], ((11, 25),))


def test_after_the_last_line_of_a_track_the_next_one_begins_the_rest() -> None:
    assert chosen(35) == ([3, 4], ((11, 35),))


def test_the_rest_from_a_line_begins_with_its_track() -> None:
    assert chosen(60, from_line=43) == ([3, 4], ((11, 35),))
    # A line between two tracks belongs to the later one.
    assert chosen(60, from_line=38) == ([3, 4], ((11, 35),))


def test_a_station_is_made_again_entirely_or_from_a_track() -> None:
    assert chosen(55, station=2) == ([0, 1, 4], ((31, 45),))
    assert chosen(55, station=2, from_track=2) == ([1, 4], ((11, 15), (31, 45)))


def test_a_track_that_was_not_executed_is_left_out_only_if_it_is_stated_to_be_made() -> None:
    with pytest.raises(PlanError, match="track 3"):
        chosen(33, from_track=4)
    assert chosen(33, from_track=4, made=True) == ([3, 4], ((11, 35),))
    with pytest.raises(PlanError, match="station 2"):
        chosen(45, station=1)


@pytest.mark.parametrize(
    "choice", [{"from_track": 0}, {"from_track": 6}, {"from_line": 56}, {"station": 7}]
)
def test_a_choice_of_nothing_is_refused(choice: dict[str, int]) -> None:
    with pytest.raises(PlanError):
        chosen(60, **choice)
    assert chosen(60, from_track=5)[0] == [4]
