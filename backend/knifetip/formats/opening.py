"""opening: open a file of any import format, and read its drawing or its pages."""

from __future__ import annotations

from dataclasses import dataclass, replace
from importlib import import_module

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.conversion import Conversion
from knifetip.formats.detection import Beginning, foreign_kind
from knifetip.formats.limits import Limits
from knifetip.formats.registry import OWN_TITLES, Format, format_of
from knifetip.model.drawing import Drawing
from knifetip.model.import_notes import add_file_notes


@dataclass(frozen=True, slots=True)
class OpenFile:
    """A file that a reader reads, after another program has converted it if its format needs it."""

    format: Format
    data: bytes  #: the content, or the converted content
    conversion: Conversion | None  #: None if the file was not converted

    def read(self, unit: str = "") -> Drawing:
        """Return the drawing in the file.

        Parameters
        ----------
        unit
            Overrides the unit of the file; "" keeps it.

        Raises
        ------
        ReadError
            The file is not a drawing, damaged, or too large.
        """
        drawing: Drawing
        reader = import_module(self.format.reader)
        if self.conversion is None:
            drawing = reader.read(self.data, unit or None)
            return drawing
        try:
            drawing = reader.read(self.data, unit or None)
        except (NotADrawing, DrawingTooLarge) as error:
            raise self.conversion.refusal_of_result(error) from error
        return _with_notes(drawing, self.conversion)

    def read_each_page(self, most: int) -> list[Drawing | NotADrawing | DrawingTooLarge]:
        """Return the drawing on each of the first ``most`` pages of the file, or why there is none.

        The format of the file has pages.

        Raises
        ------
        ReadError
            The file is not a drawing, damaged, or too large.
        """
        pages: list[Drawing | NotADrawing | DrawingTooLarge]
        pages = import_module(self.format.reader).read_each_page(self.data, most)
        return pages


def _with_notes(drawing: Drawing, conversion: Conversion) -> Drawing:
    """Return a converted drawing with rows about the conversion in its import report.

    Raises ``NotADrawing``: the result of the conversion contains no entity at all.
    """
    if len(drawing.import_report) == 0:
        raise conversion.empty_file_error()
    return replace(drawing, import_report=add_file_notes(drawing.import_report, conversion.notes))


def open_file(data: bytes) -> OpenFile:
    """Return a file of any import format, converted if its format needs it.

    Parameters
    ----------
    data
        Content of the file; its format is detected.

    Raises
    ------
    ReadError
        The file has no import format, or it must be converted and this fails or the program for it
        is not installed.
    """
    found = format_of(data)
    kind = foreign_kind(Beginning.from_bytes(data))
    if found.converter is None or kind is None:
        return OpenFile(found, data, None)
    if not found.pages:
        conversion = found.converter.convert(data, kind, OWN_TITLES, Limits())
        return OpenFile(found, conversion.data, conversion)
    pages = import_module(found.pages)
    content, number = pages.split_choice(data)
    conversion = found.converter.convert(content, kind, OWN_TITLES, Limits())
    return OpenFile(found, pages.choose_page(conversion.data, number), conversion)


def choose_page(data: bytes, number: int) -> bytes:
    """Return a file with the choice of the page ``number``, from 1, that ``OpenFile.read`` reads.

    Raises
    ------
    NotADrawing
        Files of this format have no pages, or the format is not supported.
    """
    found = format_of(data)
    if not found.pages:
        raise NotADrawing("reading.no-pages", format=found.title)
    marked: bytes = import_module(found.pages).choose_page(data, number)
    return marked


def read_each_page(data: bytes, most: int) -> list[Drawing | NotADrawing | DrawingTooLarge]:
    """Return the drawing on each of the first ``most`` pages of a file, or why there is none.

    The list is empty if files of this format have no pages.

    Raises
    ------
    ReadError
        The file is not a drawing, damaged, or too large.
    """
    return open_file(data).read_each_page(most) if format_of(data).pages else []
