"""instructions: split a plotter file into instructions.

An instruction of HPGL consists of two letters and its parameters.  Parameters are numbers between
commas or blanks, or a text.  A semicolon or the letters of the next instruction end an instruction.

A plot may be embedded in the commands of a printer (PJL and PCL), and may contain commands to the
interface of the plotter; all of them begin with the character ESC and are skipped.

Sources: HP 7475A Interfacing and Programming Manual (HP 07475-90001), chapters 2 and 10; PCL 5
Printer Language Technical Reference Manual (HP 5961-0509), chapters 17 and 18.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final, NamedTuple

import numpy as np

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits

#: Greatest value of a parameter; HP-GL/2 permits 2³⁰.
_GREATEST: Final = 1e15
#: Largest number of characters of a file in a message.
_MAX_SHOWN: Final = 20
#: Length of parameters (bytes) above which numbers are counted before they are parsed.
_LONG: Final = 1 << 16
#: Number of bytes in which the first command of a file must begin.
_HEAD: Final = 256

_BLANK: Final = rb"[\x00-\x1a\x1c-\x20]"
_NEXT: Final = re.compile(
    rb"(?:" + _BLANK + rb"|[;:])*(?:([A-Za-z]{2})([-+\d.,\x00-\x1a\x1c-\x20]*))?"
)
_NUMBER: Final = re.compile(rb"[-+]?(?:\d+\.?\d*|\.\d+)")
_SEPARATOR: Final = re.compile(rb"(?:,|" + _BLANK + rb")*")
#: Two commas without a number between them, or a comma before the first number.  A comma after the
#: last number is only a separator; plotters accept it, and instruments write "PA,PU".
_MISSING: Final = re.compile(rb"," + _BLANK + rb"*,|^" + _BLANK + rb"*," + _BLANK + rb"*[-+.\d]")
_ANY_BLANK: Final = re.compile(_BLANK + rb"+")
_TO_BLANKS: Final = bytes.maketrans(bytes(range(0x1B)) + b"\x1c\x1d\x1e\x1f,", b" " * (0x1B + 5))

#: Instructions with a text that ends with the label terminator.
_LABELS: Final = frozenset(("LB", "BL", "WD"))
#: Instructions with parameters that may be texts between quotation marks.
_QUOTED: Final = frozenset(("CO", "BP", "MG"))
_QUOTED_PARAMETERS: Final = re.compile(rb'(?:"[^"]*"|[^;"\x1b])*')
#: Instructions with a character as their first parameter.
_CHARACTER: Final = frozenset(("DT", "SM"))
_CHARACTER_PARAMETERS: Final = re.compile(rb"([^;])?[^;A-Za-z\x1b]*", re.DOTALL)
#: End of a label by default: the control character ETX.
_LABEL_END: Final = b"\x03"

_TO_INTERFACE: Final = re.compile(rb"\x1b\.[@A-Z()](?:[-\d;,]*:)?")
_TO_PLOT: Final = re.compile(rb"\x1b%-?\d*B")
_TO_PRINTER: Final = re.compile(rb"\x1b%-?\d*A|\x1bE")
_TO_JOB: Final = re.compile(rb"\x1b%-12345X(?:@PJL[^\r\n]*[\r\n]*)*")
_IS_PLOT: Final = re.compile(rb"ENTER\s+LANGUAGE\s*=\s*HPGL", re.IGNORECASE)


class Instruction(NamedTuple):
    """An instruction of a plotter file."""

    name: str  #: two capital letters
    position: int  #: of the first letter in the file (bytes, from 1)
    values: list[float]  #: parameters that are numbers
    text: bytes = b""  #: parameters that are no numbers: label, character, encoded polyline
    ended: bool = True  #: False if the file ends within the parameters


def parse_instructions(data: bytes, limits: Limits) -> Iterator[Instruction]:
    """Yield the instructions of a plotter file, whose content is ``data``.

    Raises
    ------
    NotADrawing
        The file contains something that is no instruction, a parameter is not a number, or the
        file ends inside a text.
    DrawingTooLarge
        An instruction has more coordinates than the limit of segments.
    """
    position = _plot_start(data)
    label_end = _LABEL_END
    while position < len(data):
        match = _NEXT.match(data, position)
        assert match is not None  # because the pattern matches an empty text
        if match[1] is None:
            position = match.end()
            if position < len(data):
                position = _skip_command(data, position)
            continue
        name = match[1].decode().upper()
        begin, after = match.start(1) + 1, match.start(2)
        position = match.end()
        if name in _LABELS:
            end = data.find(label_end, after)
            if end < 0:
                raise NotADrawing("plt.cut-short", position=begin, name=name)
            position = end + 1
            yield Instruction(name, begin, [], data[after:end])
        elif name == "PE":
            end = data.find(b";", after)
            if end < 0:
                raise NotADrawing("plt.cut-short", position=begin, name=name)
            position = end + 1
            yield Instruction(name, begin, [], data[after:end])
        elif name in _QUOTED:
            position = _end(_QUOTED_PARAMETERS, data, after)
            yield Instruction(name, begin, [], data[after:position])
        elif name in _CHARACTER:
            parameters = _CHARACTER_PARAMETERS.match(data, after)
            assert parameters is not None  # because the pattern matches an empty text
            character: bytes = parameters[1] or b""
            position = parameters.end()
            if name == "DT":
                label_end = character or _LABEL_END
            else:
                yield Instruction(name, begin, [], character.strip())
        else:
            if name in ("IN", "DF"):
                label_end = _LABEL_END
            values = _numbers(match[2], name, begin, limits)
            ended = position < len(data) or match[2][-1:].isspace()
            yield Instruction(name, begin, values, ended=ended)


def _end(pattern: re.Pattern[bytes], data: bytes, position: int) -> int:
    match = pattern.match(data, position)
    return position if match is None else match.end()


def _plot_start(data: bytes) -> int:
    """Return the index of the first byte of the plot; a printer's commands may precede it."""
    head = data[:_HEAD].lstrip()
    is_printed = head.startswith(b"\x1b") and _TO_INTERFACE.match(head) is None
    begin = _TO_PLOT.search(data) if is_printed else None
    return 0 if begin is None else begin.end()


def _skip_command(data: bytes, position: int) -> int:
    """Return the index behind the command that begins at ``position``.

    If the command ends the plot, the result is the index at which the next plot of the file begins;
    without another plot, it is the length of the file.

    Raises ``NotADrawing``: there is no command at ``position``.
    """
    for pattern in (_TO_INTERFACE, _TO_PLOT):
        if match := pattern.match(data, position):
            return match.end()
    if job := _TO_JOB.match(data, position):
        if _IS_PLOT.search(job[0]):
            return job.end()
    elif _TO_PRINTER.match(data, position) is None:
        text = data[position : position + _MAX_SHOWN].decode("latin-1")
        raise NotADrawing("plt.damaged", position=position + 1, text=text)
    following = _TO_PLOT.search(data, position)
    return len(data) if following is None else following.end()


def _numbers(text: bytes, name: str, position: int, limits: Limits) -> list[float]:
    """Return the numbers of the parameters ``text`` of an instruction.

    A sign may separate two numbers, as in ``PA3-4``.
    """
    if not text:
        return []
    if len(text) > _LONG:
        _count(text, limits)
    stripped = text.translate(_TO_BLANKS)
    try:
        values = list(map(float, stripped.split()))
    except ValueError:
        values = _signed_numbers(text, name, position)
    if (values and max(max(values), -min(values)) > _GREATEST) or _MISSING.search(text):
        raise _not_numbers(text, name, position)
    return values


def _count(text: bytes, limits: Limits) -> None:
    """Raise DrawingTooLarge if long parameters have more points than the limit of segments."""
    codes = np.frombuffer(text, np.uint8)
    is_separator = (codes <= 0x20) | (codes == ord(","))
    numbers = np.count_nonzero(is_separator[1:] & ~is_separator[:-1]) + 1
    if numbers > 2 * limits.segments + 2:
        raise DrawingTooLarge("reading.too-many-segments", format="HPGL", limit=limits.segments)


def _signed_numbers(text: bytes, name: str, position: int) -> list[float]:
    """Return the numbers in a text in which a sign may follow a number without a separator."""
    values = []
    at = _end(_SEPARATOR, text, 0)
    while at < len(text):
        match = _NUMBER.match(text, at)
        if match is None:
            raise _not_numbers(text, name, position)
        values.append(float(match[0]))
        at = _end(_SEPARATOR, text, match.end())
        if at == match.end() < len(text) and text[at : at + 1] not in b"+-":
            raise _not_numbers(text, name, position)
    return values


def _not_numbers(text: bytes, name: str, position: int) -> NotADrawing:
    shown = _ANY_BLANK.sub(b" ", text[:_MAX_SHOWN]).decode("latin-1")
    return NotADrawing("plt.bad-number", position=position, name=name, text=shown)


def count_is_wrong(one: Instruction, *expected: int) -> NotADrawing:
    """Return the error for an instruction with a wrong number of values.

    ``expected`` contains the right numbers of values, or the smallest of them.
    """
    return NotADrawing(
        "plt.wrong-count",
        position=one.position,
        name=one.name,
        count=len(one.values),
        expected=[str(count) for count in expected],
    )
