"""Decimals parsed by the kernel equal those of ``float`` to the last bit, or are left to it."""

from __future__ import annotations

import math
import struct

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from knifetip.dxf.decimals import EXACT, UNSURE, WRONG, number


def _read(text: str) -> tuple[float, int, int]:
    data = np.frombuffer(text.encode(), np.uint8)
    value, after, sure = number(data, np.uint64(0), np.uint64(len(data)))
    return float(value), int(after), int(sure)


def _bits(value: float) -> bytes:
    return struct.pack("<d", value)


@given(st.floats(allow_nan=False, allow_infinity=False))
@example(0.1)
@example(5e-324)
@example(2.2250738585072014e-308)
@example(1.7976931348623157e308)
def test_shortest_spelling_of_any_number_is_read_to_the_last_bit(value: float) -> None:
    read, _, sure = _read(repr(value))
    assert sure == UNSURE or _bits(read) == _bits(value)


@given(st.integers(0, 10**19 - 1), st.integers(-340, 320), st.booleans())
@example(9007199254740993, 0, False)  # halfway between two doubles
@example(9007199254740992, -20, True)
@example(18446744073709551615, 0, False)
@example(7205759403792793199, -16, False)
def test_nineteen_digits_with_any_exponent_are_read_as_float_reads_them(
    digits: int, power: int, negative: bool
) -> None:
    text = f"{'-' if negative else ''}{digits}E{power}"
    read, _, sure = _read(text)
    assert sure != WRONG
    assert sure == UNSURE or _bits(read) == _bits(float(text))


@given(st.floats(-5000.0, 5000.0), st.integers(0, 17))
def test_coordinates_with_a_fixed_number_of_decimals_are_exact(value: float, places: int) -> None:
    text = f"{value:.{places}f}"
    read, _, sure = _read(text)
    if len(text.strip("-0.").replace(".", "")) <= 15:
        assert sure == EXACT
    assert sure == UNSURE or _bits(read) == _bits(float(text))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0", 0.0),
        ("-0.0", -0.0),
        ("+5", 5.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("  12.5 \t", 12.5),
        ("1e3", 1000.0),
        ("1E+3", 1000.0),
        ("250.40", 250.4),
        ("1e22", 1e22),
        ("2500.00000000000000000000", 2500.0),
        ("12.3000000000000007105427357601001858711242675781", 12.3),
        ("123456789012345678901", 123456789012345678901.0),
        ("0.000000000000000000000000000001", 1e-30),
        ("00000000000000000000000000012.50", 12.5),
    ],
)
def test_usual_spellings_are_exact(text: str, value: float) -> None:
    read, _, sure = _read(text)
    assert sure == EXACT
    assert _bits(read) == _bits(value)


@pytest.mark.parametrize(
    "text", ["", " ", "-", ".", "nan", "inf", "1_000", "0x10", "1.5D3", "1 2", "1e", "1e+", "12,5"]
)
def test_other_spellings_are_no_numbers(text: str) -> None:
    assert _read(text)[2] == WRONG


@pytest.mark.parametrize("text", ["1e400", "1e-400", "5e-324", "9007199254740993.0000000000"])
def test_numbers_too_large_small_or_long_are_left_to_float(text: str) -> None:
    assert _read(text)[2] == UNSURE


def test_number_ends_with_its_line() -> None:
    value, after, sure = _read("12.5\r\n40\n")
    assert (value, after, sure) == (12.5, 4, EXACT)


def test_both_zeros_keep_their_sign() -> None:
    assert math.copysign(1.0, _read("-0")[0]) == -1.0
    assert math.copysign(1.0, _read("0")[0]) == 1.0
