"""Models for cartons: styles with the schemas of their parameters, and cartons to draw."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import BaseModel, Field, create_model

from knifetip.cartons.parameters import MOST, CartonSize
from knifetip.cartons.registry import STYLES
from knifetip.cartons.style import Style
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import Name, Parameters
from knifetip.service.order_details.models import OrderDetailsIn


class CodedCarton(CartonSize):
    """A style with its dimensions and options."""

    code: str


def _coded(style: Style) -> type[CodedCarton]:
    """Return the parameters of a style with its code, which identifies the style."""
    word = "".join(part.capitalize() for part in style.code.replace(".", "-").split("-"))
    fields: Any = {"code": (Literal[style.code], Field(description="Code of the style"))}
    base: Any = (style.parameters, CodedCarton)
    made: type[CodedCarton] = create_model(
        f"Carton{word}", __base__=base, __doc__=f"{style.name}.", **fields
    )
    return made


if TYPE_CHECKING:
    CartonIn: TypeAlias = CodedCarton
else:
    #: A carton of one of the styles, which ``code`` names.
    CartonIn = Annotated[
        reduce(or_, [_coded(style) for style in STYLES.values()]), Field(discriminator="code")
    ]


class CartonDrawingIn(OrderDetailsIn):
    """A carton that is to be drawn."""

    carton: CartonIn = Field(description="Style, inner dimensions (mm) and options of the carton")
    board: Name = Field(
        description="Name of the board in the library, as in `GET /api/boards`; its thickness "
        "decides the allowances"
    )
    name: Name | None = Field(
        default=None, description="Name of the drawing; null for code, dimensions and board"
    )


class CartonQuery(Parameters):
    """Parameters of the picture of a carton; those that are missing are those of the example."""

    length: float | None = Field(default=None, gt=0.0, le=MOST, description="Inner length (mm)")
    width: float | None = Field(default=None, gt=0.0, le=MOST, description="Inner width (mm)")
    depth: float | None = Field(default=None, gt=0.0, le=MOST, description="Inner depth (mm)")
    board: Name | None = Field(
        default=None, description="Name of the board; that of the example if it is missing"
    )
    options: str = Field(
        default="{}",
        max_length=2000,
        description='JSON object with the options of the style, such as `{"tuck": 20}`',
    )


class CartonStyleOut(BaseModel):
    """A carton style."""

    code: str = Field(description="Code of the style, such as `fefco-0427`")
    name: MessageOut = Field(description="Name of the style")
    description: MessageOut = Field(description="What the style is, in one line")
    parameters: dict[str, Any] = Field(
        description="JSON Schema of the dimensions and options, with titles, limits and defaults"
    )
    example: dict[str, Any] = Field(description="Usual dimensions and options")
    board: str = Field(description="Name of a board that suits the example")
    materials: list[str] = Field(
        description="Materials for which the style is made, as in `GET /api/boards`"
    )
