"""xml_builder: parse an XML file of limited size and depth, and report where it is damaged."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Final
from xml.parsers import expat

from knifetip.errors import DrawingTooLarge, NotADrawing
from knifetip.formats.limits import Limits

#: Deepest nesting of elements; drawing programs stay below 50.
_MAX_DEPTH: Final = 256
#: Errors of the parser at the end of a file that is incomplete.
_TRUNCATED: Final = frozenset(
    expat.errors.codes[text]
    for text in (
        expat.errors.XML_ERROR_NO_ELEMENTS,
        expat.errors.XML_ERROR_UNCLOSED_TOKEN,
        expat.errors.XML_ERROR_PARTIAL_CHAR,
        expat.errors.XML_ERROR_UNCLOSED_CDATA_SECTION,
    )
)


class XmlBuilder(ABC):
    """Builds the content of an XML file from its elements, which Expat parses.

    Parameters
    ----------
    limits
        Limits of the number of elements.
    format_name
        Name of the file format in error messages.
    """

    def __init__(self, limits: Limits, format_name: str) -> None:
        self.depth = 0  #: number of open elements
        self._count = 0
        self._limit = limits.entities
        self._format_name = format_name

    @abstractmethod
    def start(self, name: str, attributes: dict[str, str]) -> None:
        """Handle the start of an element, whose attributes have the names of the file."""

    @abstractmethod
    def end(self, name: str, /) -> None:
        """Handle the end of an element."""

    @abstractmethod
    def text(self, text: str) -> None:
        """Handle text between two tags."""

    @abstractmethod
    def restrict(self, parser: expat.XMLParserType) -> None:
        """Set the handlers of ``parser`` that refuse parts of XML, such as a DOCTYPE."""

    def parse(self, data: bytes) -> None:
        """Parse the content of a file.

        Raises
        ------
        NotADrawing
            The file is not XML, or is truncated or damaged.
        DrawingTooLarge
            The number or depth of elements exceeds the limits.
        """
        parser = expat.ParserCreate()
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self.text
        self.restrict(parser)
        try:
            parser.Parse(data, True)
        except (LookupError, ValueError) as error:
            # An encoding that the XML declaration names and Python does not have.
            raise self._damage_error(1, 0, str(error)) from None
        except expat.ExpatError as error:
            if error.code in _TRUNCATED:
                raise NotADrawing(
                    "reading.cut-short",
                    line=error.lineno,
                    count=self._count,
                    format=self._format_name,
                ) from None
            reason = expat.ErrorString(error.code) or "damaged"
            raise self._damage_error(error.lineno, error.offset, reason) from None

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self.depth += 1
        self._count += 1
        if self.depth > _MAX_DEPTH:
            raise DrawingTooLarge(
                "reading.nested-too-deep", limit=_MAX_DEPTH, format=self._format_name
            )
        if self._count > self._limit:
            raise DrawingTooLarge(
                "reading.too-many-elements", limit=self._limit, format=self._format_name
            )
        self.start(name, attributes)

    def _end(self, name: str) -> None:
        self.end(name)
        self.depth -= 1

    def _damage_error(self, line: int, column: int, reason: str) -> NotADrawing:
        return NotADrawing(
            "reading.damaged-at",
            line=line,
            column=column,
            reason=reason,
            format=self._format_name,
        )
