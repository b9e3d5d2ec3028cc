"""encoding: the character encoding of a DXF.

bytes, header variables -> name of an encoding          text with escapes -> text
"""

from __future__ import annotations

import re
from typing import Final

#: A character that is written by its code point: ``\U+5200``.
_ESCAPE: Final = re.compile(r"\\U\+([A-Fa-f0-9]{4})")
#: Python's names of the code pages in $DWGCODEPAGE, by the digits at its end.
CODE_PAGES: Final = {
    **{str(page): f"cp{page}" for page in range(1250, 1259)},
    **{"874": "cp874", "932": "cp932", "936": "gbk", "949": "cp949", "950": "cp950"},
}


def spelled(name: str) -> str:
    """Return a name with the format's own way to write foreign letters, ``\\U+5200``, undone."""
    if "\\U+" not in name:
        return name
    return _ESCAPE.sub(lambda escape: chr(int(escape[1], 16)), name)


def encoding_of(data: bytes, variables: dict[str, str]) -> str:
    """Return the encoding of the file's texts.

    From R2007 on it is UTF-8.  Before, the header names a code page, but many programs write
    UTF-8 under a header that says ANSI_1252, or says nothing: what is valid UTF-8 is taken as such.
    """
    if variables.get("$ACADVER", "") >= "AC1021" or data.isascii():
        return "utf-8"
    page = variables.get("$DWGCODEPAGE", "ANSI_1252")
    if page == "ANSI_1252":
        try:
            data.decode("utf-8")
        except UnicodeDecodeError:
            return "cp1252"
        return "utf-8"
    known = (name for digits, name in CODE_PAGES.items() if page.endswith(digits))
    return next(known, "cp1252")
