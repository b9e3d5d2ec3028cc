"""fonts: the fonts of job tickets, and texts of letters that these have."""

from __future__ import annotations

import logging
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from fontTools.ttLib import TTFont as FontFile
from fontTools.ttLib import TTLibError
from fpdf import FPDF
from fpdf.errors import FPDFException
from fpdf.fonts import TTFFont

FAMILY: Final = "ticket"
_FOLDER: Final = Path(__file__).parents[1] / "fonts"
_FILES: Final = {"": "DejaVuSansCondensed.ttf", "B": "DejaVuSansCondensed-Bold.ttf"}
#: Printed for a letter that no font has.
BOX: Final = "□"

_log = logging.getLogger("knifetip.ticket")


class TicketFonts:
    """The fonts of a PDF file: those of knifetip, and those that the server has besides."""

    def __init__(self, pdf: FPDF, further: Sequence[str] = ()) -> None:
        """Add the fonts to a PDF file.

        Parameters
        ----------
        further
            Files of fonts for letters that the fonts of knifetip lack.  One that cannot be read is
            left out and reported in the log.
        """
        for style, file in _FILES.items():
            pdf.add_font(FAMILY, style, _FOLDER / file)
        names = [FAMILY]
        for number, file in enumerate(further):
            name = f"further{number}"
            try:
                _check_font(Path(file))
                for style in _FILES:
                    pdf.add_font(name, style, file)
            except (
                TTLibError,
                FPDFException,
                OSError,
                KeyError,
                ValueError,
                AssertionError,
            ) as reason:
                _log.warning("the font %s cannot be used: %s", file, reason)
                continue
            names.append(name)
        pdf.set_fallback_fonts(names[1:], exact_match=False)
        regular, bold = (_letters(pdf, f"{FAMILY}{style}") for style in _FILES)
        self._known = (regular & bold).union(*(_letters(pdf, name) for name in names[1:]))
        self.has_boxes = False  #: whether a text had a letter that no font has

    def printable(self, text: str) -> str:
        """Return a text with a box for each letter that no font has.

        Control characters become spaces, except for line breaks.  Invisible characters that control
        the direction of a text are left out: the direction follows from the letters.
        """
        shown = []
        for letter in unicodedata.normalize("NFC", text):
            category = unicodedata.category(letter)
            if letter == "\n":
                shown.append(letter)
            elif category == "Cf" or 0xFE00 <= ord(letter) <= 0xFE0F:
                continue
            elif category in ("Cc", "Zl", "Zp", "Zs"):
                shown.append(" ")
            elif ord(letter) in self._known:
                shown.append(letter)
            else:
                self.has_boxes = True
                shown.append(BOX)
        return "".join(shown)


def _check_font(path: Path) -> None:
    """Raise an error if a file is not a font; ``add_font`` would leave such a file open."""
    with path.open("rb") as file:
        FontFile(file)


def _letters(pdf: FPDF, name: str) -> set[int]:
    """Return the code points of the letters of a font that was added to a PDF file."""
    font = pdf.fonts[name]
    return set(font.cmap) if isinstance(font, TTFFont) else set()
