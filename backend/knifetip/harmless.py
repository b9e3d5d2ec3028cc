"""harmless: escape control characters in texts from files and requests before they are shown.

Names of drawings, layers and operators come from files and requests.  Escape codes in them would
control the terminal, a newline would forge a log record, and a right-to-left override would display
one name as another.
"""

from __future__ import annotations

import re
from typing import Final

# Control characters (C0, DEL, C1), line separators, marks and overrides of the writing direction,
# and surrogates, which no encoding of a terminal can represent.
_ACTING: Final = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff\ud800-\udfff]"
)


def harmless(text: str, keep: str = "") -> str:
    r"""Return a text in which acting characters are written as escapes such as ``\x1b``.

    Parameters
    ----------
    text
        Any text.
    keep
        Acting characters that are not replaced, such as a newline.
    """
    return _ACTING.sub(lambda found: found[0] if found[0] in keep else _escape(found[0]), text)


def _escape(character: str) -> str:
    code = ord(character)
    return {"\n": "\\n", "\r": "\\r", "\t": "\\t"}.get(
        character, f"\\x{code:02x}" if code < 256 else f"\\u{code:04x}"
    )
