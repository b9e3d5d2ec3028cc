"""Models for orders that contain the file of their drawing, and for several orders at once."""

from __future__ import annotations

import base64
from typing import Annotated, Any, Final, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, ValidationError, WrapValidator
from pydantic.config import JsonDict
from pydantic_core import ErrorDetails

from knifetip.errors import RequestError
from knifetip.model.layout import Layout
from knifetip.service.cartons.models import CartonIn
from knifetip.service.drawings.models import DrawingSummary, Unit
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import JsonBody, Name, QuestionOut
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.order_models import JobChoices
from knifetip.service.refusals.text_faults import text_faults


class FileIn(JsonBody):
    """A drawing file within JSON."""

    name: Name = Field(description="File name, such as tray.dxf")
    content: str = Field(
        description="Content of the file in base64",
        json_schema_extra={"contentEncoding": "base64"},
    )

    def decoded(self) -> bytes:
        """Return the content of the file.

        Raises
        ------
        RequestError
            The content is not base64.
        """
        try:
            return base64.b64decode(self.content, validate=True)
        except ValueError as reason:
            raise RequestError("request.not-base64", name=self.name) from reason


#: Fields of an order of which exactly one is given.
_SOURCES: Final = {"drawing": "string", "carton": "object", "layout": "object", "file": "object"}


def _one_of(sources: dict[str, str]) -> JsonDict:
    """Return a JSON Schema by which exactly one of some fields is given.

    Generators of clients disregard it, unlike ``oneOf``.
    """
    (name, kind), *rest = sources.items()
    if not rest:
        return {"required": [name], "properties": {name: {"type": kind}}}
    return {
        "if": {"required": [name], "properties": {name: {"type": kind}}},
        "then": {"properties": {other: {"type": "null"} for other, _ in rest}},
        "else": _one_of(dict(rest)),
    }


class OrderIn(JobChoices):
    """An order: a file, a stored drawing, a carton or a layout, and choices for its job."""

    model_config = ConfigDict(json_schema_extra=_one_of(_SOURCES))

    file: FileIn | None = Field(
        default=None,
        description="The drawing in a format that `GET /formats` lists; null if `drawing` or "
        "`carton` is given, or if the file is a part of the form",
    )
    drawing: Name | None = Field(
        default=None, description="Id of a stored drawing; null if a file or a carton is given"
    )
    carton: CartonIn | None = Field(
        default=None,
        description="A carton that is drawn for the board of the order: its style as in `GET "
        "/api/cartons`, its inner dimensions (mm) and its options; null if a file or a drawing is "
        "given",
    )
    layout: Layout | None = Field(
        default=None,
        description="A sheet with stored drawings at their places, which is stored as a layout; "
        "null if another of these fields is given. The layout gets the `external_id` of the order "
        "as its name",
    )
    unit: Unit | None = Field(
        default=None, description="Unit of the file; null for the unit that the file states"
    )


class InvalidOrder(BaseModel):
    """An order whose fields are invalid, among others that are executed."""

    faults: list[Any] = Field(description="Errors in the form of pydantic")

    def faults_at(self, index: int) -> list[ErrorDetails]:
        """Return the errors with their paths in a request whose orders are in a list.

        Parameters
        ----------
        index
            Number of the order in the list, from 0.
        """
        faults: list[ErrorDetails] = self.faults
        return [{**one, "loc": ("body", "orders", index, *one["loc"])} for one in faults]


def _order(value: Any, _: object) -> OrderIn | InvalidOrder:
    if faults := text_faults(value):
        return InvalidOrder(faults=faults)
    try:
        return OrderIn.model_validate(value)
    except ValidationError as reason:
        return InvalidOrder(faults=reason.errors(include_url=False))


#: An order with a result of its own: its errors do not refuse the request.
ListedOrder: TypeAlias = Annotated[
    OrderIn | InvalidOrder, WrapValidator(_order, json_schema_input_type=OrderIn)
]


class OrdersIn(JsonBody):
    """Several orders, each of which is executed or refused independently."""

    orders: list[ListedOrder] = Field(min_length=1, max_length=100, description="The orders")


class OrderOut(BaseModel):
    """The drawing and the job of an order."""

    drawing: DrawingSummary = Field(description="The drawing")
    job: JobOut = Field(description="The job")


class OrderResult(BaseModel):
    """Result of one of several orders."""

    index: int = Field(description="Number of the order in the request, from 0")
    status: int = Field(
        description="HTTP status that this order alone would have had: 201 if its job was created"
    )
    drawing: str | None = Field(
        description="Id of the drawing; null if it was not stored. It is kept if the job was "
        "refused"
    )
    job_id: str | None = Field(description="Id of the job; null if it was not created")
    job: JobOut | None = Field(
        description="The job; null if it was not created, or if the server failed before it could "
        "describe it: `job_id` is then given"
    )
    problem: MessageOut | None = Field(
        description="Why the order was refused, failed or was not tried; null if it succeeded"
    )
    source: list[str] = Field(
        default=[],
        description="Paths of the fields, or handles of the entities, that the problem concerns; "
        "empty if there are none",
    )
    edges: list[int] = Field(
        default=[],
        description="Rows of the edges of the drawing that the problem concerns, at most 1000; "
        "empty if there are none",
    )
    questions: list[QuestionOut] = Field(
        default=[], description="Questions for which it was refused; empty if there are none"
    )
