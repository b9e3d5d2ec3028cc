"""text: decode the texts on a PDF page, with their positions, if their font has a known encoding.

For example, ``BT /F1 12 Tf 10 20 Td (A carton) Tj ET`` gives "A carton" at (10, 20), height 12.

Texts are never cut, but they are evidence for the unit and the board.  The codes of a font are
defined by a standard encoding or by a ToUnicode table; fonts without either are not decoded.

Source: ISO 32000-1, chapters 9.6 and 9.10.
"""

from __future__ import annotations

import math
import re
from typing import Any, Final, NamedTuple

from pypdf.generic import DictionaryObject, StreamObject

from knifetip.geometry.affine import IDENTITY, Matrix, compose
from knifetip.pdf.document import PdfFile

_CODECS: Final = {"/WinAnsiEncoding": "cp1252", "/MacRomanEncoding": "mac-roman"}
#: Largest number of bytes of a table to Unicode; a table of all characters is smaller.
_TABLE: Final = 1 << 20
#: Largest number of codes in a range; the standard allows 256.
_RANGE: Final = 256

_CHAR: Final = re.compile(rb"<\s*([0-9A-Fa-f]+)\s*>\s*<([0-9A-Fa-f\s]*)>")
_SPAN: Final = re.compile(
    rb"<\s*([0-9A-Fa-f]+)\s*>\s*<\s*([0-9A-Fa-f]+)\s*>\s*(?:<([0-9A-Fa-f\s]*)>|\[([^\]]*)\])"
)
_LISTED: Final = re.compile(rb"<([0-9A-Fa-f\s]*)>")


class Font(NamedTuple):
    """The encoding of a PDF font: a Python codec, or a table from character codes to text."""

    codec: str  #: name of a Python codec, empty if there is a table or none
    wide: int  #: bytes in one code
    table: dict[int, str]

    def decode(self, codes: bytes) -> str | None:
        """Return the text that a string of character codes represents.

        None is returned if the encoding of the font is unknown.
        """
        if self.codec:
            return codes.decode(self.codec, "replace")
        if not self.table:
            return None
        parts = (codes[k : k + self.wide] for k in range(0, len(codes), self.wide))
        return "".join(self.table.get(int.from_bytes(part, "big"), "\ufffd") for part in parts)


UNDECODABLE: Final = Font("", 1, {})


def parse_font(file: PdfFile, node: object) -> Font:
    """Return the encoding of the font that the PDF object ``node`` defines.

    The constant ``UNDECODABLE`` is returned if the encoding is unknown or ``node`` is not a
    dictionary.
    """
    if not isinstance(node, DictionaryObject):
        return UNDECODABLE
    wide = 2 if file.entry(node, "/Subtype") == "/Type0" else 1
    table = file.entry(node, "/ToUnicode")
    if isinstance(table, StreamObject):
        return Font("", wide, _table(file.data(table)[:_TABLE]))
    if wide == 2 or file.entry(node, "/Subtype") == "/Type3":
        return UNDECODABLE
    encoding = file.entry(node, "/Encoding")
    if isinstance(encoding, DictionaryObject):
        # /Differences are ignored: they seldom contain letters.
        encoding = file.entry(encoding, "/BaseEncoding")
    return Font(_CODECS.get(str(encoding), "cp1252"), 1, {})


def _table(data: bytes) -> dict[int, str]:
    texts: dict[int, str] = {}
    for part in data.split(b"beginbf")[1:]:
        section = part.partition(b"endbf")[0]
        if section.startswith(b"char"):
            texts |= {int(code, 16): _letters(text) for code, text in _CHAR.findall(section)}
            continue
        for first, last, text, listed in _SPAN.findall(section):
            low = int(first, 16)
            codes = range(low, min(int(last, 16), low + _RANGE - 1) + 1)
            letters = [_letters(one) for one in _LISTED.findall(listed)]
            if text and (base := _letters(text)) and ord(base[-1]) + len(codes) < 0x110000:
                letters = [base[:-1] + chr(ord(base[-1]) + k) for k in range(len(codes))]
            texts |= dict(zip(codes, letters, strict=False))
    return texts


def _letters(digits: bytes) -> str:
    plain = b"".join(digits.split())
    return bytes.fromhex((plain + b"0" * (-len(plain) % 4)).decode()).decode("utf-16-be", "replace")


#: A displacement below this (thousandths of the font size) separates words.
_BLANK: Final = -200.0


class TextObject:
    """The text between the operators BT and ET of a content stream, and the current font."""

    def __init__(self) -> None:
        self.font = UNDECODABLE
        self.size = 0.0
        self._begin: Matrix | None = None
        self._line = IDENTITY
        self._leading = 0.0
        self._parts: list[str] = []
        self._unread = False

    def begin(self) -> None:
        """Start a new text at the operator BT: remove the previous text and reset the position."""
        self._begin, self._line, self._leading = None, IDENTITY, 0.0
        self._parts.clear()
        self._unread = False

    def operate(self, operator: str, operands: list[Any]) -> None:
        """Apply a text operator with its operands to the text.

        ``operator`` is one of ``OPERATORS``.
        """
        numbers = [one for one in operands if isinstance(one, float)]
        if operator == "Tm" and len(numbers) == 6:
            a, b, c, d, e, f = numbers
            self._move((a, b, c, d, e, f), new_line=f != self._line[5])
        elif operator in ("Td", "TD") and len(numbers) == 2:
            x, y = numbers
            if operator == "TD":
                self._leading = -y
            self._move(compose(self._line, (1.0, 0.0, 0.0, 1.0, x, y)), new_line=y != 0.0)
        elif operator == "TL" and numbers:
            self._leading = numbers[0]
        elif operator in ("T*", "'", '"'):
            down = (1.0, 0.0, 0.0, 1.0, 0.0, -self._leading)
            self._move(compose(self._line, down), new_line=True)
        if operator in SHOW_OPERATORS and operands:
            self._show(operands[-1])

    def _move(self, line: Matrix, *, new_line: bool) -> None:
        if new_line and self._parts:
            self._parts.append(" ")
        self._line = line

    def _show(self, shown: object) -> None:
        if self._begin is None:
            self._begin = self._line
        for part in shown if isinstance(shown, list) else [shown]:
            if isinstance(part, bytes):
                text = self.font.decode(part)
                self._unread |= text is None
                self._parts.append(text or "")
            elif isinstance(part, float) and part < _BLANK:
                self._parts.append(" ")

    @property
    def empty(self) -> bool:
        """Whether no text was shown since the last operator BT."""
        return self._begin is None

    @property
    def begins(self) -> list[tuple[float, float]]:
        """The start point (x, y) of the text as a list of one point; empty if no text was shown.

        The point is in the coordinate system that applies before the operator BT.
        """
        return [] if self._begin is None else [self._begin[4:]]

    def placed_text(self, matrix: Matrix) -> tuple[str, float, float, float] | None:
        """Return the text between BT and ET, x and y of its start point, and its height (points).

        None is returned if the text is blank, cannot be decoded or has no finite position.

        Parameters
        ----------
        matrix
            Matrix from the coordinate system before the operator BT to points on the page.
        """
        text = " ".join("".join(self._parts).split())
        if self._begin is None or self._unread or not text:
            return None
        a, b, c, d, e, f = compose(matrix, self._begin)
        position = e, f, abs(self.size) * math.sqrt(abs(a * d - b * c))
        return (text, *position) if all(map(math.isfinite, position)) else None


#: Operators that show text, and all operators of text objects.
SHOW_OPERATORS: Final = frozenset(("Tj", "TJ", "'", '"'))
OPERATORS: Final = SHOW_OPERATORS | {"Tm", "Td", "TD", "TL", "T*"}
