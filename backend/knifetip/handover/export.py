"""export: write figures in the formats of other programs."""

from __future__ import annotations

from typing import Final, Literal, NamedTuple

from knifetip.errors import DrawingTooLarge
from knifetip.model.figure import Figure

ExportFormat = Literal["svg", "png", "dxf", "pdf"]
#: Sides of a PNG picture (pixels).
LEAST_WIDTH: Final = 64
MOST_WIDTH: Final = 4096


class _Kind(NamedTuple):
    media_type: str
    most: int  #: most lines and arcs of a file, which take some seconds


_KINDS: Final = {
    "svg": _Kind("image/svg+xml", 1_000_000),
    "png": _Kind("image/png", 1_000_000),
    "dxf": _Kind("image/vnd.dxf", 200_000),
    "pdf": _Kind("application/pdf", 200_000),
}


def media_type(form: ExportFormat) -> str:
    """Return the media type of a format."""
    return _KINDS[form].media_type


def export(figure: Figure, form: ExportFormat, width: int) -> bytes:
    """Return a figure as a file.

    Parameters
    ----------
    form
        Format of the file.
    width : pixels
        Longer side of a PNG picture, ``LEAST_WIDTH`` to ``MOST_WIDTH``.

    Raises
    ------
    DrawingTooLarge
        The figure has more lines and arcs than a file of the format may have.
    """
    most = _KINDS[form].most
    if figure.edge_count > most:
        raise DrawingTooLarge("export.too-large", count=figure.edge_count, limit=most, format=form)
    match form:
        case "svg":
            from knifetip.handover.svg import write_svg

            return write_svg(figure)
        case "png":
            from knifetip.handover.png import write_png

            return write_png(figure, width)
        case "dxf":
            from knifetip.dxf.export import export_dxf

            return export_dxf(figure)
        case "pdf":
            from knifetip.handover.pdf import write_pdf

            return write_pdf(figure)
