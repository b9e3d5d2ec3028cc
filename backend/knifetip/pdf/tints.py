"""tints: compute the colour in which programs display an amount of a spot colour's ink.

A tint is the amount of the ink, 0…1.  The PDF defines a function that converts a tint to a colour
in the alternate colour space of the spot colour, in which programs display the ink.  The function
is a power of the tint, a table, or a PostScript program.  Programs with operators other than add,
sub, mul, div, neg and stack operators, and stitched functions, are not evaluated.

Source: ISO 32000-1, chapter 7.10.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Final

from pypdf.generic import StreamObject

from knifetip.pdf.document import PdfFile, number

#: Largest number of bytes of a program, and of numbers on its stack.
_PROGRAM: Final = 4096
_STACK: Final = 100

_TWO: Final[dict[str, Callable[[float, float], float]]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
}


def evaluate_tint(file: PdfFile, function: object, tint: float) -> list[float]:
    """Return the components, in the alternate colour space, of a tint (0…1) of a spot colour.

    The list is empty if the function is invalid or not supported.

    Parameters
    ----------
    file
        The PDF.
    function
        PDF function that converts a tint to the alternate colour space.
    tint
        Amount of ink; values outside 0…1 are limited to this range.
    """
    tint = min(max(tint, 0.0), 1.0)
    kind = number(file.entry(function, "/FunctionType"))
    if kind == 2.0:
        none = [number(file.resolve(one)) for one in file.array(function, "/C0")] or [0.0]
        full = [number(file.resolve(one)) for one in file.array(function, "/C1")] or [1.0]
        power = number(file.entry(function, "/N"))
        if len(none) != len(full) or not 0.0 < power < math.inf:
            return []
        return [a + tint**power * (b - a) for a, b in zip(none, full, strict=True)]
    if kind == 0.0 and isinstance(function, StreamObject):
        return _look_up(file, function, tint)
    if kind == 4.0 and isinstance(function, StreamObject):
        return _run_program(file.data(function)[:_PROGRAM], tint)
    return []


def _look_up(file: PdfFile, function: StreamObject, tint: float) -> list[float]:
    """Return the colour components of a tint (0…1) from the nearest row of a table.

    ``function`` is the PDF function that contains the table.  The list is empty if the table is
    invalid or not supported.
    """
    size = [number(file.resolve(one)) for one in file.array(function, "/Size")]
    output_range = [number(file.resolve(one)) for one in file.array(function, "/Range")]
    bits = number(file.entry(function, "/BitsPerSample"))
    if len(size) != 1 or not 1.0 <= size[0] < math.inf or bits not in (8.0, 16.0):
        return []
    spread = [number(file.resolve(one)) for one in file.array(function, "/Decode")] or output_range
    wide = int(bits) // 8
    outputs = len(spread) // 2
    first = round(tint * (int(size[0]) - 1)) * outputs * wide
    data = file.data(function)[first : first + outputs * wide]
    if len(data) != outputs * wide:
        return []
    max_sample = float(256**wide - 1)
    return [
        low + int.from_bytes(data[k * wide : (k + 1) * wide], "big") / max_sample * (high - low)
        for k, (low, high) in enumerate(zip(spread[::2], spread[1::2], strict=True))
    ]


def _run_program(program: bytes, tint: float) -> list[float]:
    """Return the numbers that remain on the stack after a PostScript program was run on a tint.

    At the start, ``tint`` is the only number on the stack.  The list is empty if the program fails
    or has unsupported operators.
    """
    stack = [tint]
    try:
        for word in re.findall(r"[^\s{}]+", program.decode("latin-1")):
            if word in _TWO:
                b, a = stack.pop(), stack.pop()
                stack.append(_TWO[word](a, b))
            elif word == "neg":
                stack.append(-stack.pop())
            elif word == "pop":
                stack.pop()
            elif word == "dup":
                stack.append(stack[-1])
            elif word == "exch":
                stack[-2:] = stack[:-3:-1]
            elif word == "index":
                stack.append(stack[-1 - _to_count(stack.pop())])
            elif word == "copy":
                count = _to_count(stack.pop())
                stack += stack[len(stack) - count :]
            elif word == "roll":
                turn, count = int(stack.pop()), _to_count(stack.pop())
                top = stack[len(stack) - count :]
                stack[len(stack) - count :] = [top[(k - turn) % count] for k in range(count)]
            else:
                stack.append(float(word))
            if len(stack) > _STACK:
                return []
    except (ValueError, IndexError, ArithmeticError):
        return []
    return stack


def _to_count(value: float) -> int:
    """Return a number of a PostScript program as an index or a count of elements of its stack.

    A fraction is cut off.

    Raises ``ValueError``: the number is negative, or greater than the largest size of the stack.
    """
    if not 0.0 <= value <= _STACK:
        raise ValueError
    return int(value)
