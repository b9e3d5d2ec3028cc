"""Base class of options of a job that concern some edges of the drawing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, ClassVar, Literal, Self, TypeAlias, TypeVar, get_args

import numpy as np
from pydantic import Field, model_validator

from knifetip.errors import PlanError
from knifetip.fields import LISTED, PartTable, field_error
from knifetip.geometry.columns import U8
from knifetip.model.dieline import LineType

#: Line types that tools make.
MadeType: TypeAlias = Literal["cut", "crease", "v-groove", "perforation", "half-cut", "combi"]
EdgeRow = Annotated[int, Field(ge=0, le=2**31 - 1)]


class EdgeChoice(PartTable):
    """A choice for some edges of the drawing.

    A subclass adds the fields that are chosen.  An option of a job is a tuple of such choices.
    """

    #: line types of the edges for which the page offers the choice
    types: ClassVar[tuple[MadeType, ...]] = get_args(MadeType)
    #: only cutters and lasers can make the choice
    of_cutters: ClassVar[bool] = False
    #: the page has a form of its own for the choice
    own_form: ClassVar[bool] = False

    edges: tuple[EdgeRow, ...] = Field(
        strict=False,  # JSON has lists
        min_length=1,
        max_length=1000,
        description="Rows of the edges in the drawing, counted from 0",
    )


class LineTypeChoice(EdgeChoice):
    """A choice for some edges of the drawing, or for all edges of one line type.

    A choice for an edge takes precedence over one for its line type.
    """

    edges: tuple[EdgeRow, ...] = Field(
        default=(),
        strict=False,  # JSON has lists
        max_length=1000,
        description="Rows of the edges in the drawing, counted from 0; empty exactly if "
        "`line_type` is given",
    )
    line_type: Annotated[MadeType, LISTED] | None = Field(
        default=None, description="Line type of the edges, if all edges of this type are chosen"
    )

    @model_validator(mode="after")
    def _one_selection(self) -> Self:
        if bool(self.edges) == (self.line_type is not None):
            raise field_error("field.edges-or-line-type")
        return self


Choice = TypeVar("Choice", bound=EdgeChoice)
#: Value of an option of edges.
Choices = Annotated[
    tuple[Choice, ...],
    Field(strict=False, max_length=1000),  # JSON has lists
]


def choices_by_edge(choices: Sequence[Choice], line_type: U8) -> Iterator[tuple[int, Choice]]:
    """Yield each chosen edge with its choice; of several choices for one edge, the last.

    Parameters
    ----------
    choices
        The value of an option.
    line_type : (n,)
        LineType of each edge of the drawing.

    Raises
    ------
    PlanError
        The drawing has no such edge.
    """
    chosen: dict[int, Choice] = {}
    for choice in choices:
        if isinstance(choice, LineTypeChoice) and choice.line_type is not None:
            rows = np.flatnonzero(line_type == LineType.from_word(choice.line_type))
            chosen |= dict.fromkeys(rows.tolist(), choice)
    for choice in choices:
        chosen |= dict.fromkeys(choice.edges, choice)
    for row, choice in chosen.items():
        if row >= len(line_type):
            raise PlanError("edge-choice.no-edge", row=row, count=len(line_type))
        yield row, choice
