"""Parsing of content streams into operators."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.pdf.content import Name, TruncatedStream, parse_operations


def parse(data: bytes) -> list[tuple[str, list[object]]]:
    return list(parse_operations(data))


def test_operands_precede_their_operator() -> None:
    assert parse(b"1 0 0 RG\n10 -20.5 m +3 .5 l 4. 0 l S") == [
        ("RG", [1.0, 0.0, 0.0]),
        ("m", [10.0, -20.5]),
        ("l", [3.0, 0.5]),
        ("l", [4.0, 0.0]),
        ("S", []),
    ]


def test_names_strings_arrays_and_dictionaries_are_distinguished() -> None:
    ((first, given), (second, more), last) = parse(
        b"/OC /Lay#20er BDC % comment\n(a \\(b\\) (c) \\101\\n) <41 4> [3 [2] 1] <</A (>>)>> x EMC"
    )
    assert (first, given) == ("BDC", ["OC", "Lay er"])
    assert isinstance(given[1], Name)
    assert (second, more) == ("x", [b"a (b) (c) A\n", b"A@", [3.0, [2.0], 1.0], None])
    assert last == ("EMC", [])


def test_operators_need_no_separator() -> None:
    assert parse(b"[3 2]0 d/Cut CS(a)Tj") == [
        ("d", [[3.0, 2.0], 0.0]),
        ("CS", ["Cut"]),
        ("Tj", [b"a"]),
    ]


def test_an_inline_image_is_one_operator() -> None:
    data = b"BI /W 2 /H 2 /BPC 8 ID \x00 EI\xff\x01 l S( EI Q 1 w"
    assert [operator for operator, _ in parse(data)] == ["BI", "Q", "w"]


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"(abc", "pdf.open-text"),
        (b"[1 2", "pdf.open-array"),
        (b"BI /W 1 ID xxxx", "pdf.open-image"),
        (b"[" * 100, "pdf.nested-arrays"),
    ],
)
def test_a_truncated_stream_raises_an_error(data: bytes, code: str) -> None:
    with pytest.raises(TruncatedStream, match=code):
        parse(data)


@pytest.mark.parametrize(
    "again", [b"1", b"(", b"<", b"[1]", b"((", b"\\(", b"% ", b"BI ", b"<<>>", b" \t"]
)
def test_a_million_repetitions_take_seconds(again: bytes) -> None:
    start = time.process_time()
    try:
        for _ in parse_operations(again * (1_000_000 // len(again)) + b"x"):
            pass
    except TruncatedStream:
        pass
    assert time.process_time() - start < 10.0


@given(st.binary(max_size=200))
def test_any_bytes_are_parsed_or_raise_truncated_stream(data: bytes) -> None:
    try:
        for operator, given_ in parse_operations(data):
            assert operator
            assert isinstance(given_, list)
    except TruncatedStream:
        pass


@given(st.lists(st.floats(-1e6, 1e6).map(lambda value: round(value, 4)), max_size=6))
def test_written_numbers_are_parsed(numbers: list[float]) -> None:
    written = " ".join(f"{value:.4f}" for value in numbers)
    assert parse(f"{written} x".encode()) == [("x", numbers)]


def test_of_very_many_operands_the_last_ones_are_kept() -> None:
    content = b" ".join(b"%d" % number for number in range(50_003)) + b" S"
    ((operator, operands),) = parse_operations(content)
    assert operator == "S"
    assert 10_000 <= len(operands) < 20_000
    assert operands == [float(number) for number in range(50_003 - len(operands), 50_003)]
