"""parameters: the inner dimensions that all styles have, and checks of what a style permits."""

from __future__ import annotations

from typing import Annotated, Final, TypeAlias

from pydantic import Field

from knifetip.errors import ImpossibleCarton
from knifetip.fields import Table
from knifetip.model.board import Board

#: Least and greatest inner dimension of a carton (mm); most styles permit less.
LEAST: Final = 5.0
MOST: Final = 1500.0

Dimension: TypeAlias = Annotated[float, Field(ge=LEAST, le=MOST)]


class CartonSize(Table):
    """Inner dimensions of a carton."""

    length: Dimension = Field(
        title="Length",
        description="Inner length (mm): the side at which the lid or the outer flaps fold",
    )
    width: Dimension = Field(title="Width", description="Inner width (mm)")
    depth: Dimension = Field(title="Depth", description="Inner depth, from base to top (mm)")


def check_least(name: str, value: float, least: float, board: Board) -> None:
    """Raise ``ImpossibleCarton`` if the parameter ``name`` is less than ``least`` (mm)."""
    if value < least:
        raise ImpossibleCarton(
            "carton.too-small",
            parameter=name,
            value=value,
            limit=least,
            caliper=board.caliper,
            source=(name,),
        )


def check_most(name: str, value: float, most: float, board: Board) -> None:
    """Raise ``ImpossibleCarton`` if the parameter ``name`` is greater than ``most`` (mm)."""
    if value > most:
        raise ImpossibleCarton(
            "carton.too-large",
            parameter=name,
            value=value,
            limit=most,
            caliper=board.caliper,
            source=(name,),
        )
