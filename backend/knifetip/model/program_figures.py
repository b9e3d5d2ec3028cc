"""The figures that the verifier measures on a program as a whole, each declared once.

From a field of ``ProgramFigures`` come the value in the summary of a verdict, the field of the REST
API, and the lines of the command line and of the page.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Final, Literal, NamedTuple, TypeAlias, get_type_hints

#: Unit of a figure; "" for a number of things.
Unit: TypeAlias = Literal["mm", "s", ""]


class ProgramFigure(NamedTuple):
    """The declaration of a figure of a program."""

    meaning: str  #: with the unit, as the REST API describes it
    unit: Unit
    title: str  #: code of the message with its title; it is listed where it is not 0


@dataclass(frozen=True, slots=True, kw_only=True)
class ProgramFigures:
    """The figures of a program that do not belong to an edge."""

    lowest_travel: Annotated[
        float,
        ProgramFigure(
            "Least height above the board at which a tool travels over it (mm), for board that "
            "does not lie flat; 0 if no tool travels above the board, or if an older version "
            "compiled the job",
            "mm",
            "figure.lowest-travel",
        ),
    ] = 0.0
    mat_depth: Annotated[
        float,
        ProgramFigure(
            "Greatest depth of a tool below the top of the mat (mm), for the wear of the mat; 0 if "
            "no tool reaches the mat, or if an older version compiled the job",
            "mm",
            "figure.mat-depth",
        ),
    ] = 0.0


#: The declarations of all figures, by name.
PROGRAM_FIGURES: Final[Mapping[str, ProgramFigure]] = {
    name: hint.__metadata__[0]
    for name, hint in get_type_hints(ProgramFigures, include_extras=True).items()
}
