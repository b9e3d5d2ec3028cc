"""Models for test pieces: wizards with the schemas of their measures, and what follows."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import BaseModel, Field, create_model

from knifetip.fields import LISTED
from knifetip.library.definition import Shelf
from knifetip.model.job_options import CreaseDepth, CutDepth
from knifetip.service.drawings.models import DrawingOut
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import WHOLE, JsonBody, Name, Parameters
from knifetip.testpieces.registry import WIZARDS
from knifetip.testpieces.wizard import Measures, Wizard

_MACHINE = "Name of the machine in the library"
_BOARD = "Name of the board in the library"
_STATION = "Number of the station whose tool is measured"


class CodedMeasures(Measures):
    """The measures of a wizard with its code."""

    code: str


def _coded(wizard: Wizard) -> type[CodedMeasures]:
    """Return the measures of a wizard with its code, which identifies the wizard."""
    word = "".join(part.capitalize() for part in wizard.code.split("-"))
    fields: Any = {"code": (Literal[wizard.code], Field(description="Code of the test piece"))}
    base: Any = (wizard.measures, CodedMeasures)
    made: type[CodedMeasures] = create_model(
        f"Measures{word}", __base__=base, __doc__=wizard.measures.__doc__, **fields
    )
    return made


if TYPE_CHECKING:
    MeasuresIn: TypeAlias = CodedMeasures
else:
    #: The measures of one of the wizards, which ``code`` names.
    MeasuresIn = Annotated[
        reduce(or_, [_coded(wizard) for wizard in WIZARDS.values()]), Field(discriminator="code")
    ]


class WizardOut(BaseModel):
    """A test piece, and what is measured on it."""

    code: str = Field(description="Code of the test piece, such as `knife-depth`")
    name: MessageOut = Field(description="Name of the test piece")
    description: MessageOut = Field(description="What is cut, in one line")
    instruction: MessageOut = Field(description="How the piece is measured")
    kinds: list[str] = Field(description="Kinds of the tools that are measured with the piece")
    measures: dict[str, Any] = Field(
        description="JSON Schema of the measures, with titles, limits and defaults"
    )


class BenchQuery(Parameters):
    """Parameters of the picture of a test piece."""

    machine: Name = Field(description=_MACHINE)
    board: Name = Field(description=_BOARD)
    station: int = Field(ge=1, le=255, description=_STATION)


class PieceIn(JsonBody):
    """A test piece that is to be drawn."""

    code: Name = Field(description="Code of the test piece, as in `GET /api/testpieces`")
    machine: Name = Field(description=_MACHINE)
    board: Name = Field(description=_BOARD)
    station: Annotated[int, Field(ge=1, le=255), WHOLE] = Field(description=_STATION)


class PieceOut(BaseModel):
    """A test piece that is stored as a drawing, and the options with which it is ordered."""

    drawing: DrawingOut = Field(description="The drawing of the piece")
    cut_depths: list[CutDepth] = Field(
        description="Depths of cuts, to be sent with the order as `cut_depths`"
    )
    crease_depths: list[CreaseDepth] = Field(
        description="Depths of creases, to be sent with the order as `crease_depths`"
    )


class FiguresIn(JsonBody):
    """What was measured on a test piece."""

    machine: Name = Field(description=_MACHINE)
    board: Name = Field(description=_BOARD)
    station: Annotated[int, Field(ge=1, le=255), WHOLE] = Field(description=_STATION)
    measures: MeasuresIn = Field(description="Code of the test piece, and its measures")


class FigureOut(BaseModel):
    """A setting that follows from the measures."""

    name: str = Field(description="Code of the setting, such as `offset-z`")
    label: MessageOut = Field(description="What the setting is")
    shelf: Shelf | None = Field(
        description="Whose file has the setting: machines or boards; null for a setting of the "
        "controller or of the mechanics, which no file has"
    )
    path: list[str | int] = Field(
        description="Place of the value in the definition: names of fields, and places in lists "
        "from 0; empty if no file has it"
    )
    before: float = Field(description="Present value")
    after: float = Field(description="Value that follows from the measures")
    uncertainty: float = Field(
        description="Half the width of the interval in which the true value lies"
    )
    unit: Annotated[Literal["mm", "degrees", "factor", "per-mm"], LISTED] = Field(
        description="Unit of the values; factor: none"
    )
    significant: bool = Field(description="Whether the value changes by more than its uncertainty")
