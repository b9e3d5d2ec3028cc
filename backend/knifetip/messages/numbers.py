"""numbers: write numbers in the text of a message as a person writes them in a language.

Only numbers that no drawing has, of 1E15 or more, have an exponent.  Numbers are rounded as ICU
rounds them in the page: half away from zero, on the shortest decimal form of the number.
"""

from __future__ import annotations

import math
import re
from decimal import ROUND_HALF_UP, Decimal, localcontext
from typing import Final

from knifetip.messages.language import Language

#: Format of ``str.format`` with a fixed number of decimals, such as ``.3f``.
FIXED: Final = re.compile(r",?\.(?P<digits>\d)f")
#: Format of ``str.format`` with a largest number of significant digits, such as ``.3g`` or ``g``.
SIGNIFICANT: Final = re.compile(r"(?:\.(?P<digits>\d))?g")
#: Significant digits of the format ``g``, and of a number without a format.
PLAIN_DIGITS: Final = 6
ALL_DIGITS: Final = 15
#: Numbers of this size are written with an exponent, as ``src/language/numberFormat.ts`` does.
HUGE: Final = 1e15
#: Digits that a number below ``HUGE`` and the smallest decimal of a float have together.
_EXACT: Final = 400


class Position(float):
    """A coordinate, which is written without a character between its thousands: X1234.5."""


def write_number(value: float, form: str, language: Language) -> str:
    """Return a number as text in a language.

    Parameters
    ----------
    value
        The number; a ``Position`` gets no character between its thousands, except with ``,``.
    form
        Format as described in ``messages.render``: ``.2f``, ``.3g``, ``g``, ``,``, ``d``, ``mm`` or
        ``MB``; empty for all digits that the number has.
    language
        Language whose decimal character and character between thousands are used.

    Raises
    ------
    ValueError
        The format is unknown.
    """
    if not math.isfinite(value):
        return str(float(value))
    if abs(value) >= HUGE:
        return _scientific(value).replace(".", language.decimal)
    with localcontext(prec=_EXACT):
        if form == "MB":
            rounded = _fixed(Decimal(repr(value / 2**20)), 1)
        elif form == "mm":
            size = abs(value)
            digits = None if size < 1.0 else 0 if size >= 1000.0 else 1
            rounded = _significant(value, 3) if digits is None else _fixed(_exact(value), digits)
        elif form in (",", "d"):
            rounded = _fixed(_exact(value), 0)
        elif form == "":
            rounded = _significant(value, ALL_DIGITS)
        elif found := FIXED.fullmatch(form):
            rounded = _fixed(_exact(value), int(found["digits"]))
        elif found := SIGNIFICANT.fullmatch(form):
            rounded = _significant(value, int(found["digits"] or PLAIN_DIGITS))
        else:
            raise ValueError(f"the format {form!r} of a number is unknown")
    ungrouped = isinstance(value, Position) and not form.startswith(",")
    written = f"{rounded:f}" if ungrouped else f"{rounded:,f}"
    return written.translate({ord("."): language.decimal, ord(","): language.group})


def _scientific(value: float) -> str:
    """Write a number with an exponent and at most ``PLAIN_DIGITS`` significant digits."""
    with localcontext(prec=PLAIN_DIGITS, rounding=ROUND_HALF_UP):
        rounded = +_exact(value)
        exponent = rounded.adjusted()
        mantissa = rounded.scaleb(-exponent).normalize()
    return f"{mantissa:f}E{exponent}"


def _exact(value: float) -> Decimal:
    return Decimal(value) if isinstance(value, int) else Decimal(repr(float(value)))


def _fixed(exact: Decimal, digits: int) -> Decimal:
    return exact.quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP)


def _significant(value: float, digits: int) -> Decimal:
    """Round to significant digits, without zeros at the end of the decimals."""
    exact = _exact(value)
    if exact.is_zero():
        return exact.quantize(Decimal(1))
    rounded = exact.quantize(Decimal(1).scaleb(exact.adjusted() - digits + 1), ROUND_HALF_UP)
    whole = rounded.quantize(Decimal(1), ROUND_HALF_UP)
    return whole if rounded == whole else rounded.normalize()
