"""characters: the characters that a text must not contain, because nobody can see or type them.

They are the control characters of ASCII and Latin-1, and halves of surrogate pairs, which UTF-8
cannot encode.  PostgreSQL stores no NUL, and terminals and XML act on the others.
"""

from __future__ import annotations

import re
from enum import Enum
from typing import Final

# Between the brackets of a regular expression.
_LINE_ENDS: Final = r"\t\n\r"
_CONTROLS: Final = r"\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u009f"
_SURROGATES: Final = r"\ud800-\udfff"


class TextKind(Enum):
    """What a text may contain; the value are the characters that it must not contain."""

    LINE = _CONTROLS + _LINE_ENDS
    LINES = _CONTROLS  #: a text of several lines, also with tabs
    #: a text from a file or a controller, which may contain anything that every database stores
    QUOTED = r"\u0000"

    @property
    def pattern(self) -> str:
        """Pattern of JSON Schema for a text of this kind."""
        return f"^[^{self.value}]*$"


_REFUSED: Final = {kind: re.compile(f"[{kind.value}{_SURROGATES}]") for kind in TextKind}


def control_character(text: str, kind: TextKind) -> str:
    """Return the name of the first character that a text must not contain; "" if there is none.

    Parameters
    ----------
    text
        The text.
    kind
        What it may contain.

    Returns
    -------
    str
        Such as ``U+0000``.
    """
    found = _REFUSED[kind].search(text)
    return f"U+{ord(found[0]):04X}" if found else ""


def printable(text: str) -> str:
    """Return a text that UTF-8 can encode: lone surrogates become ``?``, and NUL is removed."""
    return text.encode("utf-8", "replace").decode("utf-8").replace("\0", "")
