"""Content streams as operators."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.pdf.content import CutShort, Name, operations


def said(data: bytes) -> list[tuple[str, list[object]]]:
    return list(operations(data))


def test_numbers_stand_before_their_operator() -> None:
    assert said(b"1 0 0 RG\n10 -20.5 m +3 .5 l 4. 0 l S") == [
        ("RG", [1.0, 0.0, 0.0]),
        ("m", [10.0, -20.5]),
        ("l", [3.0, 0.5]),
        ("l", [4.0, 0.0]),
        ("S", []),
    ]


def test_names_strings_arrays_and_dictionaries_are_told_apart() -> None:
    ((first, given), (second, more), last) = said(
        b"/OC /Lay#20er BDC % said\n(a \\(b\\) (c) \\101\\n) <41 4> [3 [2] 1] <</A (>>)>> x EMC"
    )
    assert (first, given) == ("BDC", ["OC", "Lay er"])
    assert isinstance(given[1], Name)
    assert (second, more) == ("x", [b"a (b) (c) A\n", b"A@", [3.0, [2.0], 1.0], None])
    assert last == ("EMC", [])


def test_operators_may_touch_what_follows() -> None:
    assert said(b"[3 2]0 d/Cut CS(a)Tj") == [
        ("d", [[3.0, 2.0], 0.0]),
        ("CS", ["Cut"]),
        ("Tj", [b"a"]),
    ]


def test_a_picture_in_the_stream_is_one_operator() -> None:
    data = b"BI /W 2 /H 2 /BPC 8 ID \x00 EI\xff\x01 l S( EI Q 1 w"
    assert [operator for operator, _ in said(data)] == ["BI", "Q", "w"]


@pytest.mark.parametrize(
    ("data", "where"),
    [
        (b"(abc", "inside a text"),
        (b"[1 2", "inside an array"),
        (b"BI /W 1 ID xxxx", "inside a picture"),
        (b"[" * 100, "nested too deep"),
    ],
)
def test_a_stream_that_is_cut_short_is_not_taken_for_whole(data: bytes, where: str) -> None:
    with pytest.raises(CutShort, match=where):
        said(data)


@pytest.mark.parametrize(
    "again", [b"1", b"(", b"<", b"[1]", b"((", b"\\(", b"% ", b"BI ", b"<<>>", b" \t"]
)
def test_what_is_repeated_a_million_times_takes_seconds_and_not_hours(again: bytes) -> None:
    begun = time.process_time()
    try:
        for _ in operations(again * (1_000_000 // len(again)) + b"x"):
            pass
    except CutShort:
        pass
    assert time.process_time() - begun < 10.0


@given(st.binary(max_size=200))
def test_no_bytes_stop_it_but_by_name(data: bytes) -> None:
    try:
        for operator, given_ in operations(data):
            assert operator
            assert isinstance(given_, list)
    except CutShort:
        pass


@given(st.lists(st.floats(-1e6, 1e6).map(lambda value: round(value, 4)), max_size=6))
def test_what_is_written_is_read(numbers: list[float]) -> None:
    written = " ".join(f"{value:.4f}" for value in numbers)
    assert said(f"{written} x".encode()) == [("x", numbers)]
