"""line_text: write program lines from their words, byte by byte."""

from __future__ import annotations

from typing import Any, NamedTuple

from knifetip.kernels import I64_1, I64_2, U8_1, Bool_1, Bool_2, OutU8_1, inline_kernel, kernel

#: Greatest number of bytes of a line: seven words of 24, a feed mode, a G word and an exact stop.
MAX_BYTES = 192


class LineWords(NamedTuple):
    """The words of n program lines; numbers are in units of their last printed decimal place."""

    code: U8_1  #: (n,) number of the G word, 0 … 3
    inverse: Bool_1  #: (n,) whether the line uses G93 (inverse time)
    ends_inverse: Bool_1  #: (n,) whether the line returns to G94
    axes: I64_2  #: (n, 4) values of the words of the axes X, Y, Z and C
    emit: Bool_2  #: (n, 4) whether each axis word is written
    centre: I64_2  #: (n, 2) values of the words I J, written if code is 2 or 3
    feed: I64_1  #: (n,) value of the F word
    emit_feed: Bool_1  #: (n,) whether the F word is written
    exact_stop: Bool_1  #: (n,) whether the move must end before the next one begins


class LineFormat(NamedTuple):
    """How a dialect writes the words of a line."""

    letters: U8_1  #: (4,) letters of the words of X, Y, Z and C
    decimals: int  #: of positions
    feed_decimals: int  #: greatest number of decimals of a feed; zeros at the end are left out
    exact_stop: U8_1  #: end of a line after which the machine must come to rest
    limit: int  #: greatest length of a line in bytes, without its end


@inline_kernel
def _write_number(value: int, decimals: int, brief: bool, out: OutU8_1, at: int) -> int:
    """Write a number at the index ``at`` of ``out``; return the index after its last byte.

    ``value`` is in units of the last of its ``decimals``.  If ``brief`` is True, zeros at the end
    of the decimals are left out, and the decimal point if no decimals remain.
    """
    if value < 0:
        out[at] = 45
        at += 1
        value = -value
    unit = 1
    for _ in range(decimals):
        unit *= 10
    whole = value // unit
    rest = value - whole * unit
    size = 1
    left = whole
    while left >= 10:
        left //= 10
        size += 1
    for place in range(at + size - 1, at - 1, -1):
        out[place] = 48 + whole % 10
        whole //= 10
    at += size
    places = decimals
    if brief:
        while places > 0 and rest % 10 == 0:
            rest //= 10
            places -= 1
        if places == 0:
            return at
    out[at] = 46
    for place in range(at + places, at, -1):
        out[place] = 48 + rest % 10
        rest //= 10
    return at + places + 1


@inline_kernel
def _write_word(letter: int, value: int, decimals: int, brief: bool, out: OutU8_1, at: int) -> int:
    """Write a space, a letter and a number; see ``_write_number``."""
    out[at] = 32
    out[at + 1] = letter
    return _write_number(value, decimals, brief, out, at + 2)


@kernel(allocates=False)
def write_lines(words: LineWords, form: LineFormat, first: int, last: int, out: OutU8_1) -> Any:
    """Write the program lines ``first`` … ``last`` - 1 to ``out``, from its start on.

    ``out`` must have room for ``MAX_BYTES`` bytes per line.  The function stops after a line that
    is longer than the limit.

    Returns
    -------
    Number of written bytes; the index of a line that is too long, or -1; and the index in ``out``
    of the first byte of the last line.
    """
    at, begin = 0, 0
    for line in range(first, last):
        begin = at
        if words.inverse[line] or words.ends_inverse[line]:
            out[at], out[at + 1], out[at + 3] = 71, 57, 32
            out[at + 2] = 51 if words.inverse[line] else 52
            at += 4
        out[at], out[at + 1] = 71, 48 + words.code[line]
        at += 2
        for axis in range(4):
            if words.emit[line, axis]:
                letter = form.letters[axis]
                value = words.axes[line, axis]
                at = _write_word(letter, value, form.decimals, False, out, at)
        if words.code[line] >= 2:
            at = _write_word(73, words.centre[line, 0], form.decimals, False, out, at)
            at = _write_word(74, words.centre[line, 1], form.decimals, False, out, at)
        if words.emit_feed[line]:
            at = _write_word(70, words.feed[line], form.feed_decimals, True, out, at)
        if at - begin > form.limit:
            return at, line, begin
        if words.exact_stop[line]:
            for byte in form.exact_stop:
                out[at] = byte
                at += 1
        else:
            out[at] = 10
            at += 1
    return at, -1, begin
