"""Parse the bytes of a program into words, and list the faults of its lines.

A word is a letter and a number, such as G1 or X20.  The bytes may come from any source.  Text that
is not a program gives faults, not exceptions.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any, Final

import numpy as np

from knifetip.errors import ProgramUnreadable
from knifetip.kernels import U8_1, inline_kernel, kernel
from knifetip.messages import Message
from knifetip.verification.columns import F64, I32, U8

#: Greatest size of a program (bytes).
MAX_BYTES: Final = 64 << 20
#: Longest line that LinuxCNC reads (bytes).
MAX_LINE: Final = 255
#: Greatest number; no table is that large.
MAX_NUMBER: Final = 1e6

#: Messages by the scanner's fault code; the argument is the wrong byte.
_FAULTS: Final[Mapping[int, Callable[[int], Message]]] = {
    1: lambda byte: Message("rs274.bad-character", character=chr(byte)),
    2: lambda _: Message("rs274.nested-comment"),
    3: lambda _: Message("rs274.open-comment"),
    4: lambda byte: Message("rs274.letter-without-number", letter=chr(byte)),
    5: lambda _: Message("rs274.too-many-digits"),
    6: lambda _: Message("rs274.line-too-long", limit=MAX_LINE),
    7: lambda _: Message("rs274.number-too-large"),
}
_MAX_FAULTS: Final = 1000
#: Comments that LinuxCNC executes: they run Python, write files, or stop the program.
_ACTIVE_COMMENT: Final = re.compile(
    rb"[(;][ \t]*(?:abort|debug|log\w*|print|probe\w*|py)[ \t]*,", re.IGNORECASE
)
_PLACEMENT: Final = re.compile(rb"\(placement X(-?\d+\.\d+) Y(-?\d+\.\d+)\)")


#: Bytes below 0x80 that grbl executes at once, even inside a line or a comment.
_REALTIME: Final = b"!~?\x18"


@dataclass(frozen=True, eq=False, slots=True)
class ProgramWords:
    """The n words of a program in the order of the text, and the faults of its lines."""

    line: I32  #: (n,) 1-based, ascending
    letter: U8  #: (n,) ASCII code of the capital letter
    value: F64  #: (n,) the number after the letter
    faults: tuple[tuple[int, Message], ...]  #: (1-based line, message)
    lines: int  #: number of lines in the text


def comment_placement(text: bytes) -> tuple[float, float] | None:
    """Return the placement that the program's comments state, or None if they state none.

    The placement is the offset (x, y) in mm from the drawing's to the sheet's coordinates.
    """
    match = _PLACEMENT.search(text)
    return (float(match[1]), float(match[2])) if match else None


def parse_words(text: bytes) -> ProgramWords:
    """Return the words of a program.

    Raises
    ------
    ProgramUnreadable
        The text is not of type bytes, or is longer than 64 MB.
    """
    if not isinstance(text, bytes | bytearray | memoryview):
        raise ProgramUnreadable("program.not-bytes", type=type(text).__name__)
    if len(text) > MAX_BYTES:
        raise ProgramUnreadable("program.too-large", bytes=len(text), limit=MAX_BYTES)
    raw = np.frombuffer(text, np.uint8)
    line, letter, value, faults, lines = _scan_words(raw, MAX_LINE, MAX_NUMBER)
    messages = [
        (int(row), _FAULTS[int(code)](int(byte))) for row, code, byte in faults[:_MAX_FAULTS]
    ]
    return ProgramWords(line, letter, value, tuple(messages), int(lines))


def realtime_bytes(text: bytes) -> list[tuple[int, Message]]:
    """Return faults for bytes that grbl executes as real-time commands, even inside a comment.

    Each fault is (1-based line, message), in ascending order, at most ``_MAX_FAULTS``.
    """
    text = bytes(text)
    if text.isascii() and not any(byte in text for byte in _REALTIME):
        return []
    raw = np.frombuffer(text, np.uint8)
    acts = np.isin(raw, np.frombuffer(_REALTIME, np.uint8)) | (raw >= 0x80)
    positions = np.flatnonzero(acts)[:_MAX_FAULTS]
    line = 1 + np.searchsorted(np.flatnonzero(raw == 10), positions)
    return [
        (int(row), Message("rs274.control-byte", byte=f"{int(byte):#04x}"))
        for row, byte in zip(line, raw[positions], strict=True)
    ]


def active_comments(text: bytes) -> list[tuple[int, Message]]:
    """Return faults for comments that LinuxCNC executes, such as ``(PY,…)`` and ``(ABORT,…)``.

    Each fault is (1-based line, message), in ascending order, at most ``_MAX_FAULTS``.
    """
    # Only comments with a comma are executed, and programs of this package contain none.
    text = bytes(text)
    if b"," not in text:
        return []
    matches = islice(_ACTIVE_COMMENT.finditer(text), _MAX_FAULTS)
    return [
        (1 + text.count(b"\n", 0, match.start()), Message("rs274.active-comment"))
        for match in matches
    ]


@inline_kernel
def _scan_number(raw: U8_1, at: int) -> tuple[int, float, int]:
    """Read the decimal number that begins at index ``at`` in the bytes ``raw`` of a program.

    Returns the index of the byte after the number, the value of the number, and its number of
    digits.  If there are no digits, the value and the number of digits are 0.  The value is wrong
    if there are more than 15 digits.
    """
    size = len(raw)
    negative = False
    if at < size and (raw[at] == 43 or raw[at] == 45):
        negative = raw[at] == 45
        at += 1
    digits = 0
    mantissa = 0
    scale = 1.0
    point = False
    while at < size and (48 <= raw[at] <= 57 or (raw[at] == 46 and not point)):
        if raw[at] == 46:
            point = True
        else:
            digits += 1
            if digits <= 15:
                # Below 2^53, so the quotient is the float nearest to the decimal number.
                mantissa = mantissa * 10 + (raw[at] - 48)
                if point:
                    scale *= 10.0
        at += 1
    value = mantissa / scale
    return at, -value if negative else value, digits


@kernel(checks_division=True)
def _scan_words(raw: U8_1, longest: int, greatest: float) -> Any:
    """Scan the bytes ``raw`` of a program once, and return its n words and k faults.

    A line of more than ``longest`` bytes is a fault, and so is a number greater than ``greatest``.
    The valid words of a line with a fault are returned too.

    Returns five values: program line, letter and value of each word, (n,) each; program line, fault
    code (a key of ``_FAULTS``) and wrong byte of each fault, (k, 3); and the number of lines of the
    program.
    """
    letters = 0
    for byte in raw:
        if 65 <= byte <= 90 or 97 <= byte <= 122:
            letters += 1
    line_of = np.empty(letters, np.int32)
    letter_of = np.empty(letters, np.uint8)
    value_of = np.empty(letters, np.float64)
    faults = np.empty((1000, 3), np.int64)
    words = 0
    wrong = 0
    line = 1
    at = 0
    began = 0
    size = len(raw)
    while at < size:
        byte = raw[at]
        code = 0
        if byte == 10:
            if at - began > longest:
                code = 6
                byte = np.uint8(32)
            began = at + 1
            at += 1
        elif byte == 32 or byte == 9 or (byte == 13 and at + 1 < size and raw[at + 1] == 10):
            at += 1
        elif byte == 59:  # ; to the end of the line
            while at < size and raw[at] != 10:
                # LinuxCNC ends the line at a zero byte.
                if raw[at] < 9:
                    code, byte = 1, raw[at]
                at += 1
        elif byte == 40:  # ( … )
            at += 1
            while at < size and raw[at] != 41 and raw[at] != 10:
                if raw[at] == 40:
                    code = 2
                if raw[at] < 9:
                    code, byte = 1, raw[at]
                at += 1
            if at < size and raw[at] == 41:
                at += 1
            else:
                code = 3
        elif 65 <= byte <= 90 or 97 <= byte <= 122:
            if byte >= 97:
                byte = np.uint8(byte - 32)
            at, value, digits = _scan_number(raw, at + 1)
            if digits == 0:
                code = 4
            elif digits > 15:
                code = 5
            elif abs(value) > greatest:
                code = 7
            else:
                line_of[words] = line
                letter_of[words] = byte
                value_of[words] = value
                words += 1
        else:
            code = 1
            at += 1
        if code > 0 and wrong < len(faults):
            faults[wrong, 0] = line
            faults[wrong, 1] = code
            faults[wrong, 2] = byte
            wrong += 1
        if began == at and at > 0 and raw[at - 1] == 10:
            line += 1
    if size - began > longest and wrong < len(faults):
        faults[wrong, 0] = line
        faults[wrong, 1] = 6
        faults[wrong, 2] = 32
        wrong += 1
    lines = line if size > began else line - 1
    return line_of[:words], letter_of[:words], value_of[:words], faults[:wrong], lines
