"""text: what the words on a page say and where, if their font lets them be read.

    BT /F1 12 Tf 10 20 Td (A carton) Tj ET -> "A carton" at (10, 20), 12 high

Words are never cut, but a carton's words tell of its unit and its board.  A font says what its
codes mean by a well-known encoding or by a table to Unicode; a font with neither is not read.

Source: ISO 32000-1, chapters 9.6 and 9.10.
"""

from __future__ import annotations

import math
import re
from typing import Any, Final, NamedTuple

from pypdf.generic import DictionaryObject, StreamObject

from knifetip.geometry.affine import IDENTITY, Matrix, chained
from knifetip.pdf.document import File

_CODECS: Final = {"/WinAnsiEncoding": "cp1252", "/MacRomanEncoding": "mac-roman"}
#: Bytes of a table to Unicode; one of all characters has fewer.
_TABLE: Final = 1 << 20
#: Codes of a range; the standard has at most 256.
_RANGE: Final = 256

_CHAR: Final = re.compile(rb"<\s*([0-9A-Fa-f]+)\s*>\s*<([0-9A-Fa-f\s]*)>")
_SPAN: Final = re.compile(
    rb"<\s*([0-9A-Fa-f]+)\s*>\s*<\s*([0-9A-Fa-f]+)\s*>\s*(?:<([0-9A-Fa-f\s]*)>|\[([^\]]*)\])"
)
_LISTED: Final = re.compile(rb"<([0-9A-Fa-f\s]*)>")


class Font(NamedTuple):
    """How the codes of a font are read."""

    codec: str  #: of Python, empty where there is a table or nothing
    wide: int  #: bytes to a code
    table: dict[int, str]

    def words(self, codes: bytes) -> str | None:
        """Return what codes say, None where that cannot be told."""
        if self.codec:
            return codes.decode(self.codec, "replace")
        if not self.table:
            return None
        parts = (codes[k : k + self.wide] for k in range(0, len(codes), self.wide))
        return "".join(self.table.get(int.from_bytes(part, "big"), "\ufffd") for part in parts)


SILENT: Final = Font("", 1, {})


def font(file: File, node: object) -> Font:
    """Return how a font is read."""
    if not isinstance(node, DictionaryObject):
        return SILENT
    wide = 2 if file.entry(node, "/Subtype") == "/Type0" else 1
    table = file.entry(node, "/ToUnicode")
    if isinstance(table, StreamObject):
        return Font("", wide, _table(file.data(table)[:_TABLE]))
    if wide == 2 or file.entry(node, "/Subtype") == "/Type3":
        return SILENT
    encoding = file.entry(node, "/Encoding")
    if isinstance(encoding, DictionaryObject):
        # Codes that the font places elsewhere; those of letters seldom are.
        encoding = file.entry(encoding, "/BaseEncoding")
    return Font(_CODECS.get(str(encoding), "cp1252"), 1, {})


def _table(data: bytes) -> dict[int, str]:
    found: dict[int, str] = {}
    for part in data.split(b"beginbf")[1:]:
        section = part.partition(b"endbf")[0]
        if section.startswith(b"char"):
            found |= {int(code, 16): _letters(text) for code, text in _CHAR.findall(section)}
            continue
        for first, last, text, listed in _SPAN.findall(section):
            low = int(first, 16)
            codes = range(low, min(int(last, 16), low + _RANGE - 1) + 1)
            letters = [_letters(one) for one in _LISTED.findall(listed)]
            if text and (base := _letters(text)) and ord(base[-1]) + len(codes) < 0x110000:
                letters = [base[:-1] + chr(ord(base[-1]) + k) for k in range(len(codes))]
            found |= dict(zip(codes, letters, strict=False))
    return found


def _letters(digits: bytes) -> str:
    plain = b"".join(digits.split())
    return bytes.fromhex((plain + b"0" * (-len(plain) % 4)).decode()).decode("utf-16-be", "replace")


#: In a line of letters: moved back by more of a thousandth of their height is a blank.
_BLANK: Final = -200.0


class Words:
    """The text between BT and ET, and the font that is used."""

    def __init__(self) -> None:
        self.font = SILENT
        self.size = 0.0
        self._begin: Matrix | None = None
        self._line = IDENTITY
        self._leading = 0.0
        self._said: list[str] = []
        self._unread = False

    def begin(self) -> None:
        """Forget what was said."""
        self._begin, self._line, self._leading = None, IDENTITY, 0.0
        self._said.clear()
        self._unread = False

    def operate(self, operator: str, given: list[Any]) -> None:
        """Follow one of the operators in ``OPERATORS``."""
        numbers = [one for one in given if isinstance(one, float)]
        if operator == "Tm" and len(numbers) == 6:
            a, b, c, d, e, f = numbers
            self._moved((a, b, c, d, e, f), new_line=f != self._line[5])
        elif operator in ("Td", "TD") and len(numbers) == 2:
            x, y = numbers
            if operator == "TD":
                self._leading = -y
            self._moved(chained(self._line, (1.0, 0.0, 0.0, 1.0, x, y)), new_line=y != 0.0)
        elif operator == "TL" and numbers:
            self._leading = numbers[0]
        elif operator in ("T*", "'", '"'):
            down = (1.0, 0.0, 0.0, 1.0, 0.0, -self._leading)
            self._moved(chained(self._line, down), new_line=True)
        if operator in SHOWN and given:
            self._shown(given[-1])

    def _moved(self, line: Matrix, *, new_line: bool) -> None:
        if new_line and self._said:
            self._said.append(" ")
        self._line = line

    def _shown(self, what: object) -> None:
        if self._begin is None:
            self._begin = self._line
        for part in what if isinstance(what, list) else [what]:
            if isinstance(part, bytes):
                words = self.font.words(part)
                self._unread |= words is None
                self._said.append(words or "")
            elif isinstance(part, float) and part < _BLANK:
                self._said.append(" ")

    @property
    def silent(self) -> bool:
        """Whether nothing was shown."""
        return self._begin is None

    @property
    def begins(self) -> list[tuple[float, float]]:
        """The point where it begins, in the coordinates around the text, if anything was shown."""
        return [] if self._begin is None else [self._begin[4:]]

    def said(self, matrix: Matrix) -> tuple[str, float, float, float] | None:
        """Return the words, where they begin and how high they are; None where they are not read.

        Parameters
        ----------
        matrix
            From the coordinates around the text to points.
        """
        words = " ".join("".join(self._said).split())
        if self._begin is None or self._unread or not words:
            return None
        a, b, c, d, e, f = chained(matrix, self._begin)
        place = e, f, abs(self.size) * math.sqrt(abs(a * d - b * c))
        return (words, *place) if all(map(math.isfinite, place)) else None


#: Operators that show letters, and all that this module follows.
SHOWN: Final = frozenset(("Tj", "TJ", "'", '"'))
OPERATORS: Final = SHOWN | {"Tm", "Td", "TD", "TL", "T*"}
