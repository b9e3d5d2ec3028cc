"""registry: the table of import formats.

    bytes -> Format -> Drawing

A format is one row of ``FORMATS`` and a room of its own with a module ``read``.  Everything else
that depends on the format is taken from its row: detection, media type, file name extensions, and
what the page offers in its file dialog.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Final

from knifetip.errors import NotADrawing
from knifetip.formats import detection
from knifetip.formats.detection import Beginning
from knifetip.model.drawing import Drawing

# A browser executes scripts in an SVG or a PDF, so both are sent as plain bytes.
_BYTES: Final = "application/octet-stream"


@dataclass(frozen=True, slots=True)
class Format:
    """An import format."""

    name: str  #: "dxf", "svg" …
    title: str  #: for a sentence: "DXF (text or binary, any version)"
    extensions: tuple[str, ...]  #: of file names, with the dot, the usual one first
    media_type: str  #: in which the stored file is sent back
    reader: str  #: module whose ``read(data, unit)`` reads it; imported when it is first needed
    #: whether a file is of this format, by its content; None for the format of all other files
    matches: Callable[[Beginning], bool] | None


#: In the order in which errors and the page list them.
FORMATS: Final = (
    Format(
        "dxf",
        "DXF (text or binary, any version)",
        (".dxf",),
        "image/vnd.dxf",
        "knifetip.dxf.read",
        None,
    ),
    Format("cf2", "CF2", (".cf2", ".cff2"), "text/plain", "knifetip.cf2.read", detection.is_cf2),
    Format("svg", "SVG", (".svg", ".svgz"), _BYTES, "knifetip.svg.read", detection.is_svg),
    Format("pdf", "PDF", (".pdf", ".ai"), _BYTES, "knifetip.pdf.read", detection.is_pdf),
)
#: Reads files of unknown content: its reader reports where they stop being one.
_FALLBACK: Final = next(one for one in FORMATS if one.matches is None)


def format_of(data: bytes) -> Format:
    """Return the format of a file, by its content.

    Raises
    ------
    NotADrawing
        The file is empty, or of a known kind that is not an import format.
    """
    titles = [one.title for one in FORMATS]
    beginning = Beginning.of(data)
    if not beginning.head:
        raise NotADrawing("reading.empty", formats=titles)
    for one in FORMATS:
        if one.matches is not None and one.matches(beginning):
            return one
    if what := detection.foreign_kind(beginning):
        raise NotADrawing("reading.unknown-kind", what=what, formats=titles)
    return _FALLBACK


def read_file(data: bytes, unit: str = "") -> Drawing:
    """Return the drawing in a file, in the unit that is given or else in that of the file.

    Raises
    ------
    ReadError
        The bytes are not a drawing, or one that is damaged or too large.
    """
    reader = import_module(format_of(data).reader)
    drawing: Drawing = reader.read(data, unit or None)
    return drawing
