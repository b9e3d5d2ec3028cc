"""encoding: find the character encoding of a DXF file, and decode escaped characters in names."""

from __future__ import annotations

import re
from typing import Final

#: A character that is written as its code point: ``\U+5200``.
_ESCAPE: Final = re.compile(r"\\U\+([A-Fa-f0-9]{4})")
#: Python's names of the code pages in $DWGCODEPAGE, by the digits at its end.
CODE_PAGES: Final = {
    **{str(page): f"cp{page}" for page in range(1250, 1259)},
    **{"874": "cp874", "932": "cp932", "936": "gbk", "949": "cp949", "950": "cp950"},
}


def unescape(name: str) -> str:
    r"""Return a name with escaped characters, such as ``\U+5200``, replaced by the characters."""
    if "\\U+" not in name:
        return name
    return _ESCAPE.sub(lambda escape: chr(int(escape[1], 16)), name)


def encoding_of(data: bytes, variables: dict[str, str]) -> str:
    """Return Python's name of the character encoding of the texts in a DXF file.

    From version R2007 on the encoding is UTF-8.  In older files it is the code page that a header
    variable names, such as ANSI_932.  Many programs, however, write UTF-8 and name the code page
    ANSI_1252 or none.  For such a file the result is UTF-8 if the content is valid UTF-8, and
    Windows-1252 if it is not.

    Parameters
    ----------
    data
        Content of the file.
    variables
        Values of the header variables by name, such as $ACADVER.
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
    page_names = (name for digits, name in CODE_PAGES.items() if page.endswith(digits))
    return next(page_names, "cp1252")
