from typing import cast

import numpy as np
import pytest

from knifetip.errors import ProgramUnreadable
from knifetip.messages import render
from knifetip.verification.reading.rs274.interpret import interpret
from knifetip.verification.reading.rs274.parse import (
    MAX_BYTES,
    active_comments,
    comment_placement,
    parse_words,
    realtime_bytes,
)
from tests.support.programs.handwritten import MACHINE


def read(text: bytes) -> list[tuple[int, str, float]]:
    words = parse_words(text)
    return [
        (int(line), chr(letter), float(value))
        for line, letter, value in zip(words.line, words.letter, words.value, strict=True)
    ]


def test_words_keep_their_line_letter_and_value() -> None:
    assert read(b"G1 X-12.5000 Y.25\n\nz3.\n") == [
        (1, "G", 1.0),
        (1, "X", -12.5),
        (1, "Y", 0.25),
        (3, "Z", 3.0),
    ]


def test_a_decimal_is_the_nearest_number_as_python_reads_it() -> None:
    chance = np.random.default_rng(3)
    numbers = [f"{value:.4f}" for value in chance.uniform(-2000.0, 2000.0, 2000)]
    text = "".join(f"X{number}\n" for number in numbers).encode()
    assert parse_words(text).value.tolist() == [float(number) for number in numbers]


def test_comments_give_no_words() -> None:
    assert read(b"(G1 X1) G0 (X2) Y3 ; Z4 (\n;G1\nC5\n") == [
        (1, "G", 0.0),
        (1, "Y", 3.0),
        (3, "C", 5.0),
    ]


def test_lines_may_end_with_crlf_and_the_last_one_without_an_end() -> None:
    words = parse_words(b"G0 X1\r\nM2")
    assert words.faults == ()
    assert words.lines == 2
    assert words.line.tolist() == [1, 1, 2]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (b"G1 X#1\n", "The character '#'"),
        (b"%\n", "The character '%'"),
        (b"G1 X1e5\n", "The letter E"),
        (b"(a (b)\n", "inside another comment"),
        (b"G0 (X1\nY1\n", "not closed"),
        (b"G1 X\n", "The letter X in the program line is not followed by a number"),
        (b"G1 X-\n", "The letter X in the program line is not followed by a number"),
        (b"G1 X1.2.3\n", "The character '.'"),
        (b"X1234567890123456\n", "more than 15 digits"),
        (b"X1000001\n", "larger than 1,000,000"),
        (b"(" + b"a" * 260 + b")\n", "longer than 255"),
        (b"(" + b"a" * 260 + b")", "longer than 255"),
    ],
)
def test_a_fault_has_the_number_of_its_line(text: bytes, expected: str) -> None:
    _, faults = interpret(parse_words(b"\n" + text), MACHINE)
    assert any(line == 2 and expected in render(fault) for line, fault in faults), faults


def test_any_bytes_are_read_without_an_error() -> None:
    chance = np.random.default_rng(7)
    for size in (0, 1, 2, 50, 5000):
        parse_words(chance.integers(0, 256, size, dtype=np.uint8).tobytes())


def test_other_types_and_too_large_texts_raise_an_error() -> None:
    with pytest.raises(ProgramUnreadable, match="of type str"):
        parse_words(cast(bytes, "G0 X1\n"))
    with pytest.raises(ProgramUnreadable, match="limit is 67,108,864"):
        parse_words(bytes(MAX_BYTES + 1))


def test_the_placement_is_read_from_the_header() -> None:
    assert comment_placement(b"(machine)\n(placement X20.0000 Y-3.5000)\nG21\n") == (20.0, -3.5)
    assert comment_placement(b"G21\n") is None


def test_realtime_bytes_of_grbl_are_faults_in_comments_too() -> None:
    assert [line for line, _ in realtime_bytes(b"(ok)\n(carton!)\nG0 X1\n(\x85)\n")] == [2, 4]


def test_comments_that_linuxcnc_executes_are_faults() -> None:
    program = (
        b"(cut, then crease)\nG0 X1 (PY, stop\n; py, stop\n( abort,x)\n(msg, wait)\n(logopen,a)\n"
    )
    assert [line for line, _ in active_comments(program)] == [2, 3, 4, 6]


def test_a_zero_byte_in_a_comment_is_a_fault() -> None:
    for text in (b"(a\0b)\nG0 X1\n", b"; a\0b\nG0 X1\n"):
        ((line, message),) = parse_words(text).faults
        assert (line, message.code) == (1, "rs274.bad-character")
