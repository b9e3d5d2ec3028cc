"""reader: read any DXF file with ezdxf.

Entities that ezdxf skips also have a row in the import report, because ``prescan`` counts the
entities in the bytes before ezdxf reads the file.
"""

from __future__ import annotations

from knifetip.drawing_builder.assemble import assemble
from knifetip.dxf.ezdxf_reader.document import load_document
from knifetip.dxf.ezdxf_reader.expand import expand
from knifetip.dxf.ezdxf_reader.place import columns, renumber_styles
from knifetip.dxf.ezdxf_reader.prescan import Prescan, prescan
from knifetip.dxf.units import known_unit
from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats import format_of
from knifetip.formats.limits import Limits
from knifetip.messages import Message
from knifetip.model.drawing import Drawing


def read_with_ezdxf(data: bytes, unit: str, limits: Limits, lines_before: int = 0) -> Drawing:
    """Return the drawing in a DXF file, read with ezdxf.

    Parameters
    ----------
    data
        Content of the file without leading blank lines.
    unit
        Unit that replaces the unit of the file if it is not empty.
    limits
        Limits of the size of the file and of the drawing.
    lines_before
        Number of blank lines before ``data`` in the file, for the line numbers in error messages.

    Raises
    ------
    NotADrawing
        The file is not a DXF file, or is damaged.
    DrawingTooLarge
        A limit is exceeded.
    """
    if (kind := format_of(data)).name != "dxf":
        raise NotADrawing("dxf.other-kind", kind=kind.title)
    if len(data) > limits.slow_bytes:
        raise DrawingTooLarge(
            "dxf.too-large-unusual", size=len(data) / 2**20, limit=limits.slow_bytes / 2**20
        )
    counted = prescan(data, lines_before)
    _check(counted, limits)
    known = known_unit(unit, data, counted.variables)
    sheet, shapes = expand(load_document(data, counted, limits), counted, limits, known.scale)
    if not counted.ended:
        sheet.row("EOF", "EOF", "", Message("import.no-end-mark", mark="EOF"))
    segments = columns(sheet, shapes, known.scale, limits)
    segments, styles = renumber_styles(segments, [shape.style for shape in shapes])
    return assemble(sheet, segments, styles, counted.annotations, known)


def _check(counted: Prescan, limits: Limits) -> None:
    """Raise an error if a file is not a DXF file, has too many entities, or is damaged.

    ``counted`` contains the entities and defects of the file.

    Raises ``NotADrawing``: the file is not a DXF file, is incomplete, or contains values that ezdxf
    would change.
    Raises ``DrawingTooLarge``: the file has too many entities.
    """
    if not counted.sections:
        if counted.broken:
            raise NotADrawing("dxf.not-a-group-code", line=counted.broken, text=counted.broken_text)
        raise NotADrawing("dxf.no-section")
    if counted.size > limits.entities:
        raise DrawingTooLarge(
            "reading.too-many-entities", count=counted.size, limit=limits.entities
        )
    unfinished = not counted.ended and "ENTITIES" not in counted.sections
    if counted.open_section in ("ENTITIES", "BLOCKS") or unfinished:
        location = (
            Message("dxf.at-line", line=counted.broken)
            if counted.broken
            else Message("dxf.without-end-mark")
        )
        section = counted.open_section or "file"
        raise NotADrawing("dxf.cut-short", where=location, section=section, count=counted.size)
    if counted.damage:
        raise counted.damage
