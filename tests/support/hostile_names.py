"""Names with an effect where they are shown: a page, a log, a terminal, a table or a header."""

from __future__ import annotations

from typing import Final

#: Hostile names by what they attack; none contains a slash, which ends the name of a file.
HOSTILE_NAMES: Final = {
    "markup": '<img src=x onerror="window.hacked=1">',
    "attribute": "' autofocus onfocus='window.hacked=1",
    "script": "<script>window.hacked=1<\\script>",
    "newline": "a\nERROR knifetip.api: the table is on fire",
    "carriage-return": "a\rX-Added: x=1\r\n\r\n<b>",
    "right-to-left": "carton\u202efxd.exe",
    "isolate": "carton\u2066fxd\u2069.dxf",
    "line-separator": "a\u2028b\u2029c",
    "nul": "a\x00b.dxf",
    "terminal-title": "a\x1b]0;owned\x07b",
    "terminal-clear": "a\x1b[2J\x1b[H\x9b31mb",
    "terminal-link": "\x1b]8;;http:evil.example\x1b\\click\x1b]8;;\x1b\\",
    "bell-and-backspace": "a\x07\x08\x08b\x7f",
    "formula": "=HYPERLINK(evil;A1)",
    "quote": 'a"; filename="b.exe',
    "format": "%s %(x)s {0} {x.__class__}",
    "surrogate": "a\ud800b",
    "zero-width": "\ufeff\u200e\u200fa",
}

#: Characters that a terminal or a log interprets.
ACTING: Final = frozenset(
    chr(code)
    for first, last in (
        *((0x00, 0x1F), (0x7F, 0x9F), (0x61C, 0x61C), (0x200E, 0x200F)),
        *((0x2028, 0x202E), (0x2066, 0x2069), (0xFEFF, 0xFEFF)),
    )
    for code in range(first, last + 1)
)


def acting(text: str, permitted: str = "") -> set[str]:
    """Return the characters of a text that act on a terminal or log, except permitted ones."""
    return {one for one in text if one in ACTING and one not in permitted}
