"""Status reports of grbl and grblHAL are parsed; damaged ones are ignored."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.gateway.controller import State
from knifetip.gateway.grbl import answers


def report_of(line: str) -> answers.Report:
    """Return the parsed status report of a line, which must contain one."""
    report = answers.report(line)
    assert report is not None
    return report


def test_a_full_report_is_read() -> None:
    report = report_of(
        "<Run|MPos:1.000,2.000,-0.300,90.000|Bf:14,110|FS:600,1|Ln:41|WCO:0.5,0,0,0|Ov:100,100,100>"
    )
    assert report.state is State.RUN
    assert report.machine == (1.0, 2.0, -0.3, 90.0)
    assert report.work is None
    assert report.offset == (0.5, 0.0, 0.0, 0.0)
    assert (report.free, report.feed, report.number) == (14, 600.0, 41)
    assert not report.still


def test_a_report_in_work_coordinates_is_read() -> None:
    assert report_of("<Idle|WPos:1.0,2.0,3.0,4.0|F:0>").work == (1.0, 2.0, 3.0, 4.0)


def test_an_axis_that_the_controller_does_not_have_is_zero() -> None:
    assert report_of("<Idle|MPos:1.0,2.0,3.0>").machine == (1.0, 2.0, 3.0, 0.0)


@pytest.mark.parametrize(
    ("word", "state", "still"),
    [
        ("Idle", State.IDLE, True),
        ("Run", State.RUN, False),
        ("Hold:0", State.HOLD, True),
        ("Hold:1", State.HOLD, False),
        ("Door:0", State.DOOR, True),
        ("Door:1", State.DOOR, True),
        ("Door:2", State.DOOR, False),
        ("Door:3", State.DOOR, False),
        ("Alarm", State.ALARM, True),
        ("Check", State.CHECK, True),
        ("Tool", State.TOOL, True),
        ("Sleep", State.SLEEP, True),
    ],
)
def test_states_are_known_and_whether_anything_moves(word: str, state: State, still: bool) -> None:
    report = report_of(f"<{word}|MPos:0,0,0,0>")
    assert (report.state, report.still) == (state, still)


@pytest.mark.parametrize(
    "line",
    ["<Run|MPos:1.0,2", "Run|MPos:1>", "<Run|MPos:a,b,c>", "<Run|MPos:nan,0,0>", "<Run|Bf:>"],
)
def test_a_damaged_report_is_no_report(line: str) -> None:
    assert answers.report(line) is None


@given(st.text(max_size=60))
def test_no_text_at_all_breaks_the_reading_of_reports(text: str) -> None:
    assert answers.report(text) is None or text[0] + text[-1] == "<>"
    answers.report(f"<{text}>")


_NUMBERS = st.sampled_from(["0", "7", "-1.5", "1e400", "nan", "-inf", "x"])


@given(
    st.sampled_from(["Idle", "Run", "Hold:0", "Tool"]),
    st.lists(
        st.tuples(
            st.sampled_from(["MPos", "WPos", "WCO", "Bf", "FS", "F", "Ln", "Ov"]),
            st.lists(_NUMBERS, min_size=1, max_size=4),
        ),
        max_size=2,
    ),
)
def test_a_report_that_is_read_has_finite_numbers_only(
    state: str, fields: list[tuple[str, list[str]]]
) -> None:
    report = answers.report(
        "<" + "|".join([state, *(f"{key}:{','.join(values)}" for key, values in fields)]) + ">"
    )
    if report is None:
        assert fields
        return
    poses = (report.machine, report.work, report.offset)
    numbers = [number for pose in poses if pose is not None for number in pose]
    assert all(map(math.isfinite, [*numbers, report.feed, report.number]))


def test_codes_have_words_and_unknown_ones_say_so() -> None:
    assert "travel" in str(answers.alarm_meaning(2))
    assert "no feed" in str(answers.error_meaning(22))
    assert answers.error_meaning(9999).code == "grbl.unknown-error"
