"""Command-line options for the options of a job.

Most options of the command line are derived from the fields of ``JobOptions``.  Those with a syntax
of their own are dataclasses of this module, whose method ``record`` returns the value of the field.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Final, Literal

import typer

from knifetip.cli.check_option import check_option
from knifetip.errors import PlanError
from knifetip.fields import InvalidFields, check_fields
from knifetip.model.corners import CornerAt, Corners
from knifetip.model.registration import Registration
from knifetip.model.sheet import Sheet

NUMBER: Final = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,2})?"
_CORNER: Final = re.compile(
    rf"\s*(?P<x>{NUMBER})\s*,\s*(?P<y>{NUMBER})\s*=\s*(?P<type>\w+)\s*(?::\s*(?P<k>{NUMBER})\s*)?",
    re.ASCII,
)
_MARK: Final = re.compile(
    rf"\s*({NUMBER})\s*,\s*({NUMBER})\s*(?:=\s*({NUMBER})\s*,\s*({NUMBER})\s*)?", re.ASCII
)
_SHEET: Final = re.compile(
    rf"\s*({NUMBER})\s*[xX×]\s*({NUMBER})\s*(?::\s*({NUMBER})\s*)?", re.ASCII
)


def parse_corner(text: str) -> CornerAt:
    """Return the corner position and the corner type that an option describes.

    Parameters
    ----------
    text
        Value of the option ``--corner-at``: ``X,Y=TYPE`` or ``X,Y=TYPE:K``.  X and Y are in mm; K
        is the parameter of type D, between 0 (like type B) and 1 (like type C).

    Raises
    ------
    PlanError
        The text does not have one of these forms.
    """
    match = _CORNER.fullmatch(text)
    if match is None:
        raise PlanError("command.bad-corner", text=text)
    k = None if match["k"] is None else float(match["k"])
    place = {"x": float(match["x"]), "y": float(match["y"])}
    return check_option(CornerAt, f"--corner-at {text}", {**place, "type": match["type"], "k": k})


@dataclass(frozen=True, slots=True)
class CornerOptions:
    """Command-line options for the path of a cutter round outer corners of a contour."""

    corner: Annotated[
        Literal["auto", "B", "C", "D"] | None,
        typer.Option(
            help="Path of the cutter at outer corners: B moves on an arc; C moves straight and "
            "stops at the corner; D moves straight with a small arc at the corner; auto takes the "
            "fastest of the three. Default: auto."
        ),
    ] = None
    k: Annotated[
        float | None,
        typer.Option(
            help="Shape of corners of type D, without a unit: 0 gives the path of type B, 1 the "
            "path of type C. Default: 0.5."
        ),
    ] = None
    interference: Annotated[
        Literal["trim", "refuse"] | None,
        typer.Option(
            help="What to do if a cutter cannot reach parts of a contour: leave these parts uncut "
            "(trim), or write no program (refuse). Default: trim."
        ),
    ] = None
    corner_at: Annotated[
        list[str] | None,
        typer.Option(
            metavar="X,Y=TYPE[:K]",
            help="Type (B, C, D or auto) of the corner at the position X,Y of the drawing, in mm; "
            "may be repeated. Default: the type in --corner.",
        ),
    ] = None

    def record(self) -> Corners | None:
        """Return the corner types that the options describe; None if no option is given.

        Raises
        ------
        PlanError
            An option has an invalid value.
        """
        given = {"type": self.corner, "k": self.k, "interference": self.interference}
        fields: dict[str, Any] = {name: word for name, word in given.items() if word is not None}
        if self.corner_at:
            fields["at"] = tuple(parse_corner(text) for text in self.corner_at)
        return check_option(Corners, "--corner", fields) if fields else None


def parse_sheet(text: str) -> Sheet | None:
    """Return the sheet that the option ``--sheet`` describes; None for an empty text.

    Parameters
    ----------
    text
        ``outline``, ``WIDTHxHEIGHT`` or ``WIDTHxHEIGHT:MARGIN``, in mm.

    Raises
    ------
    PlanError
        The text does not have one of these forms, or a size is not valid.
    """
    if not text:
        return None
    if text == "outline":
        return Sheet()
    match = _SHEET.fullmatch(text)
    if match is None:
        raise PlanError("sheet.bad-size", text=text)
    fields = {"width": float(match[1]), "height": float(match[2]), "margin": float(match[3] or 0.0)}
    try:
        return check_fields(Sheet, fields)
    except InvalidFields:
        raise PlanError("sheet.bad-size", text=text) from None


@dataclass(frozen=True, slots=True)
class SheetOptions:
    """The command-line option that describes the sheet on the table."""

    sheet: Annotated[
        str,
        typer.Option(
            metavar="WxH[:MARGIN]",
            help="The sheet was cut to this size, in mm, and the drawing lies MARGIN from its left "
            "and lower edge; or outline: the sheet was cut to the outline of the drawing. Tools "
            "turn without a lift beside such a sheet. Default: a sheet of unknown size.",
        ),
    ] = ""

    def record(self) -> Sheet | None:
        """Return the sheet that the option describes; None if it is not given."""
        return parse_sheet(self.sheet)


def parse_mark(text: str) -> tuple[tuple[float, float], tuple[float, float] | None]:
    """Return the position of a mark in the drawing, and on the table if it was measured (mm).

    Parameters
    ----------
    text
        Value of the option ``--mark``: ``X,Y`` or ``X,Y=X,Y``.

    Raises
    ------
    PlanError
        The text does not have one of these forms.
    """
    match = _MARK.fullmatch(text)
    if match is None:
        raise PlanError("command.bad-mark", text=text)
    drawn = float(match[1]), float(match[2])
    return drawn, None if match[3] is None else (float(match[3]), float(match[4]))


@dataclass(frozen=True, slots=True)
class MarkOptions:
    """Command-line options for the marks of a printed sheet."""

    mark: Annotated[
        list[str] | None,
        typer.Option(
            metavar="X,Y[=X,Y]",
            help="Mark of a printed sheet: its position in the drawing and, if it was measured, "
            "on the table, in mm; given at least twice. The program then follows the print. "
            "Default: a sheet without marks.",
        ),
    ] = None
    mark_scale: Annotated[
        Literal["fit", "keep"] | None,
        typer.Option(
            help="Whether the drawing is also scaled to the measured marks (fit) or keeps its size "
            "(keep). Default: fit."
        ),
    ] = None
    mark_limit: Annotated[
        float | None,
        typer.Option(help="Greatest permitted error of a measured mark, in mm. Default: 0.5."),
    ] = None

    def record(self) -> Registration | None:
        """Return the marks that the options describe; None if no mark is given.

        Raises
        ------
        PlanError
            An option has an invalid value.
        """
        if not self.mark:
            return None
        pairs = [parse_mark(text) for text in self.mark]
        given = {"scale": self.mark_scale, "limit": self.mark_limit}
        fields: dict[str, Any] = {name: value for name, value in given.items() if value is not None}
        fields["marks"] = tuple(drawn for drawn, _ in pairs)
        fields["measured"] = tuple(found for _, found in pairs if found is not None)
        return check_option(Registration, "--mark", fields)


@dataclass(frozen=True, slots=True)
class WorkOrderOptions:
    """The command-line option for the order of the tracks."""

    work_order: Annotated[
        str,
        typer.Option(
            metavar="EDGE,EDGE,…",
            help="Numbers of edges in the order in which the tracks along them are begun, for "
            "example 12,3,4. Default: the shortest way.",
        ),
    ] = ""

    def record(self) -> tuple[int, ...]:
        """Return the edges that the option lists.

        Raises
        ------
        PlanError
            The text is not a list of numbers.
        """
        words = [word.strip() for word in self.work_order.split(",")] if self.work_order else []
        if not all(word.isascii() and word.isdigit() for word in words):
            raise PlanError("order.bad-syntax", text=self.work_order)
        return tuple(int(word) for word in words)


#: Options of a job with a syntax of their own, by field.
SYNTAX: Final[Mapping[str, type]] = {
    "corners": CornerOptions,
    "registration": MarkOptions,
    "sheet": SheetOptions,
    "work_order": WorkOrderOptions,
}
