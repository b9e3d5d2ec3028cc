"""The blocks of a program, interpreted once for all who follow it."""

from __future__ import annotations

import math

import pytest

from knifetip.gateway import program_blocks
from knifetip.gateway.interpreter import Block, Interpreter
from knifetip.gateway.program_blocks import ProgramBlocks, lines_of, read_blocks
from knifetip.gateway.stream import TYPICAL

PROGRAM = b"G21 G90 G94\nG0 X100\nG1 X5 Q7\nG4 P2\nG1 X300 F6000\nG53 G0 X0\nM30"


class Counting(Interpreter):
    """An interpreter that counts the lines that it reads."""

    lines = 0

    def read(self, line: bytes) -> Block:
        Counting.lines += 1
        return super().read(line)


def test_lines_come_one_by_one_with_or_without_a_last_newline() -> None:
    assert list(lines_of(b"G0\nG1\n")) == list(lines_of(b"G0\nG1")) == [b"G0", b"G1"]
    assert list(lines_of(b"")) == []


@pytest.mark.parametrize(("kept", "interpretations"), [(7, 1), (6, 2)])
async def test_a_program_is_interpreted_once_unless_it_is_too_long(
    monkeypatch: pytest.MonkeyPatch, kept: int, interpretations: int
) -> None:
    monkeypatch.setattr(program_blocks, "KEPT", kept)
    monkeypatch.setattr(Counting, "lines", 0)
    blocks = ProgramBlocks(PROGRAM, Counting)
    times = await blocks.measure(TYPICAL)
    expected = list(read_blocks(PROGRAM, Interpreter()))
    assert len(times) == len(expected) == 7
    # All at 5000 mm/s².  G0 X100 reaches no full speed before the dwell.  G1 goes 200 mm at 100
    # mm/s from rest to 5 mm/s, as X jumps by 10 mm/s at the turn.  G53 goes back 300 mm at 1000
    # mm/s.
    turned = 0.02 + 0.019 + (200.0 - 1.0 - 0.9975) / 100.0
    back = 0.199 + 0.2 + (300.0 - 99.9975 - 100.0) / 1000.0
    expected_times = [0.0, 2.0 * math.sqrt(100.0 / 5000.0), 0.0, 2.0, turned, back, 0.0]
    assert list(times) == pytest.approx(expected_times, rel=1e-5)
    one, other = blocks.readers()
    ahead = [next(one) for _ in range(5)]
    behind = list(other)
    for read in (ahead + list(one), behind):
        assert [None if block is None else repr_of(block) for block in read] == [
            None if block is None else repr_of(block) for block in expected
        ]
    assert Counting.lines == 7 * interpretations
    assert expected[2] is None
    assert [block.in_machine_coordinates for block in expected if block] == [False] * 4 + [
        True,
        False,
    ]


def repr_of(block: Block) -> tuple[object, ...]:
    end = None if block.move is None else block.move.end
    return block.dwell, block.end, block.output, end
