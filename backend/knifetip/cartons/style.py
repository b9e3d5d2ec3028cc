"""style: the record of a carton style."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from knifetip.cartons.carton import Carton
from knifetip.cartons.parameters import CartonSize
from knifetip.messages import Message
from knifetip.model.board import Board


@dataclass(frozen=True, slots=True)
class Style:
    """A carton style: its parameters, and the function that draws it."""

    code: str  #: such as "fefco-0427"
    name: Message
    description: Message  #: what the style is, in one line
    parameters: type[CartonSize]
    draw: Callable[[Any, Board], Carton]  #: called with an instance of ``parameters``
    example: CartonSize  #: usual parameters, for pictures
    board: str  #: name of a board of the library that suits the example
    materials: tuple[str, ...]  #: materials of boards for which the style is made
