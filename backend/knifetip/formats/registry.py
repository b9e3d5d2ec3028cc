"""The table of import formats.

A format is one row of ``FORMATS`` and a package with a module ``read``.  Detection, media type,
file name extensions and the file dialog of the page are all derived from this row.  A format may
have a converter instead of a reader of its own: a program that need not be installed, which
converts its files to another format.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from knifetip.errors import NotADrawing
from knifetip.formats import detection
from knifetip.formats.conversion import GHOSTSCRIPT, LIBREDWG, Converter
from knifetip.formats.detection import Beginning

# Browsers execute scripts in SVG and PDF, so both are sent as binary data.
_BYTES: Final = "application/octet-stream"


@dataclass(frozen=True, slots=True)
class Format:
    """An import format: name, extensions, media type, detection function and reader module."""

    name: str  #: "dxf", "svg" …
    title: str  #: name in messages, the same in all languages: "DXF"
    extensions: tuple[str, ...]  #: file name extensions with the dot, most common first
    media_type: str  #: media type of downloads
    reader: str  #: module with ``read(data, unit)``; imported on first use
    #: whether a file has this format; None for the format of all other files
    matches: Callable[[Beginning], bool] | None
    #: module with ``choose_page(data, number)`` and ``split_choice(data)``; "" without pages
    pages: str = ""
    converter: Converter | None = None  #: program that converts files for ``reader``

    @property
    def is_available(self) -> bool:
        """Whether files can be read: a program that must convert them is installed."""
        return self.converter is None or self.converter.find() is not None


#: All formats, in the order of messages and of the page.
FORMATS: Final = (
    Format("dxf", "DXF", (".dxf",), "image/vnd.dxf", "knifetip.dxf.read", None),
    Format("cf2", "CF2", (".cf2", ".cff2"), "text/plain", "knifetip.cf2.read", detection.is_cf2),
    Format("svg", "SVG", (".svg", ".svgz"), _BYTES, "knifetip.svg.read", detection.is_svg),
    Format(
        "pdf",
        "PDF",
        (".pdf", ".ai"),
        _BYTES,
        "knifetip.pdf.read",
        detection.is_pdf,
        "knifetip.pdf.chosen_page",
    ),
    Format("plt", "HPGL", (".plt", ".hpgl"), _BYTES, "knifetip.hpgl.read", detection.is_plot),
    Format(
        "lightburn",
        "LightBurn",
        (".lbrn2", ".lbrn"),
        _BYTES,
        "knifetip.lightburn.read",
        detection.is_lightburn,
    ),
    Format(
        "eps",
        "EPS",
        (".eps", ".ps"),
        _BYTES,
        "knifetip.pdf.read",
        detection.is_postscript,
        "knifetip.pdf.chosen_page",
        GHOSTSCRIPT,
    ),
    Format(
        "dwg",
        "DWG",
        (".dwg",),
        _BYTES,
        "knifetip.dxf.read",
        detection.is_dwg,
        converter=LIBREDWG,
    ),
)
#: Titles of the formats that knifetip reads without another program.
OWN_TITLES: Final = [one.title for one in FORMATS if one.converter is None]
#: Format of files with unknown content; its reader reports what is wrong.
_FALLBACK: Final = next(one for one in FORMATS if one.matches is None)


def format_of(data: bytes) -> Format:
    """Return the format of a file, detected by its content.

    A file that has no known format is treated as a DXF file, because DXF files have no signature.

    Raises
    ------
    NotADrawing
        The file is empty or has a known format that cannot be imported.
    """
    beginning = Beginning.from_bytes(data)
    if not beginning.head:
        raise NotADrawing("reading.empty", formats=OWN_TITLES)
    for one in FORMATS:
        if one.matches is not None and one.matches(beginning):
            return one
    if kind := detection.foreign_kind(beginning):
        raise NotADrawing("reading.unknown-kind", what=kind, formats=OWN_TITLES)
    return _FALLBACK
