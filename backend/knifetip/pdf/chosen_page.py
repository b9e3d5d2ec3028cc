"""chosen_page: the page of a PDF that the user has chosen, as a comment after the end of the file.

A stored drawing is a file and a unit, and is read again from them, so the file itself contains the
choice.  Programs ignore a comment after the end of a PDF.
"""

from __future__ import annotations

import re
from typing import Final

_MARK: Final = re.compile(rb"\n%knifetip page ([1-9]\d{0,5})\n\Z")


def choose_page(data: bytes, number: int) -> bytes:
    """Return the PDF ``data`` with the choice of the page ``number``, from 1.

    An earlier choice is replaced.
    """
    data, _ = split_choice(data)
    return data + b"\n%%knifetip page %d\n" % number


def split_choice(data: bytes) -> tuple[bytes, int]:
    """Return a PDF without the choice of a page, and the number of the page, 1 without a choice."""
    match = _MARK.search(data[-32:])
    if match is None:
        return data, 1
    return data[: -len(match[0])], int(match[1])
