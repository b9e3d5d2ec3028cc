"""Models for the details of an order: numbers of other systems, customer, due time, metadata."""

from __future__ import annotations

import json
from typing import Annotated, Any, Final, TypeAlias

from fastapi import Request
from fastapi.exceptions import RequestValidationError
from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    StrictBool,
    StrictStr,
    TypeAdapter,
    ValidationError,
)

from knifetip.fields import field_error
from knifetip.service.http.models import JsonBody
from knifetip.service.http.times import Moment, MomentIn, in_order
from knifetip.service.order_details.details import DetailsFilter

#: Query parameters with this prefix filter by the metadata; the rest of the name is the key.
METADATA_PREFIX: Final = "metadata."
_MOST_BYTES: Final = 8192

ExternalId: TypeAlias = Annotated[
    str,
    Field(max_length=200, description="Number of the order or the article in another system"),
]
Customer: TypeAlias = Annotated[
    str, Field(max_length=200, description="Name or number of the customer")
]
Notes: TypeAlias = Annotated[str, Field(max_length=2000, description="Notes for the operator")]


def _check_size(value: dict[str, Any]) -> dict[str, Any]:
    if len(json.dumps(value, ensure_ascii=False).encode("utf-8", "replace")) > _MOST_BYTES:
        raise field_error("field.metadata-too-large", most=_MOST_BYTES >> 10)
    return value


Number: TypeAlias = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Whole: TypeAlias = Annotated[int, Field(strict=True, ge=-(2**53), le=2**53)]
Metadata: TypeAlias = Annotated[
    dict[
        Annotated[str, Field(min_length=1, max_length=100)],
        StrictBool | Whole | Number | StrictStr,
    ],
    Field(
        max_length=32,
        description="Up to 32 values of other systems by key: texts, numbers, true and false; 8 kB "
        "together",
    ),
    AfterValidator(_check_size),
]


class OrderDetailsIn(JsonBody):
    """Details of an order in a request; they are returned and found, and change no program."""

    external_id: ExternalId = ""
    customer: Customer = ""
    due: MomentIn | None = Field(
        default=None, description="Time at which the order is due, with offset; null for none"
    )
    notes: Notes = ""
    metadata: Metadata = Field(default={})


class OrderDetailsPatch(JsonBody):
    """New details of an order; fields that are missing stay as they are."""

    external_id: ExternalId | None = Field(default=None, description="Null removes the number")
    customer: Customer | None = Field(default=None, description="Null removes the customer")
    due: MomentIn | None = Field(default=None, description="Null removes the due time")
    notes: Notes | None = Field(default=None, description="Null removes the notes")
    metadata: Metadata | None = Field(
        default=None, description="Replaces all metadata; null removes them"
    )


class OrderDetailsOut(BaseModel):
    """Details of an order in an answer."""

    external_id: str = Field(
        default="", description="Number of the order or the article in another system; may be empty"
    )
    customer: str = Field(default="", description="Name or number of the customer; may be empty")
    due: Moment | None = Field(
        default=None, description="Time at which the order is due; null for none"
    )
    notes: str = Field(default="", description="Notes for the operator; may be empty")
    metadata: dict[str, bool | int | float | str] = Field(
        default={}, description="Values of other systems by key"
    )


class DetailsQuery(BaseModel):
    """Query parameters that select drawings or jobs by the details of their orders."""

    # ``metadata.KEY`` stands for any key; ``known_fields`` refuses all other unknown names.
    model_config = ConfigDict(extra="ignore")

    external_id: str = Field(
        default="", max_length=200, description="Number in another system; empty for all"
    )
    customer: str = Field(
        default="", max_length=200, description="Name or number of the customer; empty for all"
    )
    due_after: MomentIn | None = Field(
        default=None, description="Earliest due time; null for no limit"
    )
    due_before: MomentIn | None = Field(
        default=None, description="Time before which the order is due; null for no limit"
    )
    notes: str = Field(
        default="", max_length=200, description="Part of the notes, in any case; empty for all"
    )
    _due_in_order = in_order(("due_after", "due_before"))
    metadata: str | None = Field(
        default=None,
        alias="metadata.KEY",
        description="Value of the metadata with the key KEY, such as `metadata.line=3`; may be "
        "given for several keys, and all must match",
    )


class TimesQuery(BaseModel):
    """Query parameters that select drawings or jobs by their creation and their last change."""

    created_after: MomentIn | None = Field(
        default=None, description="Earliest creation; null for no limit"
    )
    created_before: MomentIn | None = Field(
        default=None, description="Time before which it was created; null for no limit"
    )
    updated_after: MomentIn | None = Field(
        default=None,
        description="Earliest last change, for what has changed since; null for no limit",
    )
    updated_before: MomentIn | None = Field(
        default=None, description="Time before which it was changed last; null for no limit"
    )

    _ordered = in_order(("created_after", "created_before"), ("updated_after", "updated_before"))


_COLUMNS: Final = {name: name for name in ("external_id", "customer", "due", "notes")} | {
    "metadata": "extra"
}
_EMPTY: Final[dict[str, Any]] = {
    "external_id": "", "customer": "", "due": None, "notes": "", "metadata": {},
}  # fmt: skip


def details_columns(details: OrderDetailsIn) -> dict[str, Any]:
    """Return the details of a request by name of the column that stores them."""
    return {column: getattr(details, name) for name, column in _COLUMNS.items()}


def changed_columns(patch: OrderDetailsPatch) -> dict[str, Any]:
    """Return the details that a request changes, by name of the column that stores them."""
    return {
        column: _EMPTY[name] if (value := getattr(patch, name)) is None else value
        for name, column in _COLUMNS.items()
        if name in patch.model_fields_set
    }


def details_fields(row: Any) -> dict[str, Any]:
    """Return the details of a drawing or a job by name of the field."""
    return {name: getattr(row, column) for name, column in _COLUMNS.items()}


def _parse_json(value: Any) -> Any:
    if not isinstance(value, str):
        return value
    try:
        return json.loads(value or "{}")
    except json.JSONDecodeError as reason:
        raise field_error("field.bad-json", line=reason.lineno, column=reason.colno) from reason
    except (ValueError, RecursionError) as reason:
        raise field_error("field.nested-too-deep") from reason


_FORM: Final = TypeAdapter[dict[str, Any]](Annotated[Metadata, BeforeValidator(_parse_json)])


def metadata_of(text: str) -> dict[str, Any]:
    """Return the metadata in a part of a form, which is a JSON object as text.

    Raises
    ------
    RequestValidationError
        The text is no JSON object, or its values are not permitted.
    """
    try:
        return _FORM.validate_python(text)
    except ValidationError as reason:
        faults = reason.errors(include_url=False)
        raise RequestValidationError(
            [{**fault, "loc": ("body", "metadata", *fault["loc"])} for fault in faults]
        ) from None


def details_filter(query: DetailsQuery, request: Request) -> DetailsFilter:
    """Return the conditions on the details of orders that a request for a list contains."""
    labels = {
        name.removeprefix(METADATA_PREFIX): value
        for name, value in request.query_params.items()
        if name.startswith(METADATA_PREFIX)
    }
    return DetailsFilter(
        query.external_id,
        query.customer,
        query.due_after,
        query.due_before,
        query.notes,
        labels,
        *(
            getattr(query, name, None)
            for name in ("created_after", "created_before", "updated_after", "updated_before")
        ),
    )
