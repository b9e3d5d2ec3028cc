"""Moves that leave the travel of a controller are found before a program starts."""

from __future__ import annotations

from math import inf

import pytest

from knifetip.gateway.interpreter import Interpreter
from knifetip.gateway.program_blocks import read_blocks
from knifetip.gateway.travel import Excess, Travel, find_excess

#: X 0 … 100, Y -50 … 50, Z up to 20; the zero of programs lies at X 10 of the machine.
TRAVEL = Travel((0.0, -50.0, -inf, -360.0), (100.0, 50.0, 20.0, 360.0), (10.0, 0.0, 0.0, 0.0))


async def excess(*lines: bytes) -> Excess | None:
    text = b"".join(line + b"\n" for line in (b"G21 G90 G17", *lines))
    return await find_excess(read_blocks(text, Interpreter()), TRAVEL)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        (b"G0 X90", None),
        (b"G0 X90.0009", None),
        (b"G0 X90.002", Excess(2, 0, 100.002, 100.0)),
        (b"G0 X-10.5", Excess(2, 0, -0.5, 0.0)),
        (b"G1 Y-51 F600", Excess(2, 1, -51.0, -50.0)),
        (b"G0 Z20.5", Excess(2, 2, 20.5, 20.0)),
        (b"G0 Z-900", None),
        (b"G0 C-361", Excess(2, 3, -361.0, -360.0)),
        (b"G53 G0 X95", None),
    ],
)
async def test_an_end_is_compared_in_coordinates_of_the_machine(
    line: bytes, expected: Excess | None
) -> None:
    found = await excess(line)
    assert (found is None) == (expected is None)
    if found is not None and expected is not None:
        assert (found.line, found.axis, found.limit) == (
            expected.line,
            expected.axis,
            expected.limit,
        )
        assert found.position == pytest.approx(expected.position)


async def test_the_first_line_that_leaves_the_travel_is_named() -> None:
    found = await excess(b"G0 X20", b"G7", b"G0 Y60", b"G0 X500")
    assert found == Excess(4, 1, 60.0, 50.0)


async def test_an_arc_is_compared_between_its_ends() -> None:
    # Half circles over Y 40 with radius 20: only the upper one leaves the travel, at Y 60.
    start = b"G0 X40 Y40"
    assert await excess(start, b"G2 X80 Y40 I20 J0 F600") == Excess(3, 1, 60.0, 50.0)
    assert await excess(start, b"G3 X80 Y40 I20 J0 F600") is None


async def test_a_full_circle_is_compared_on_all_sides() -> None:
    # Around X 15 of the machine with radius 20: as far as X -5.
    found = await excess(b"G0 X25 Y0", b"G3 X25 Y0 I-20 J0 F600")
    assert found == Excess(3, 0, -5.0, 0.0)
