"""files: validate the fields of TOML files against pydantic models.

``validate_fields`` returns a validated model, or raises an error with the path of each invalid
field and the reason.  Numbers must be finite, and types are not converted.  Unknown fields are
errors.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from typing import Any, Final, TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import ErrorDetails, PydanticCustomError

from knifetip.errors import KnifetipError, LibraryError
from knifetip.messages import Message
from knifetip.messages.codes import CODES

Model = TypeVar("Model", bound="Table")

#: Largest number of faults of one file in an error.
_MOST = 5


class Table(BaseModel):
    """Base class of the pydantic models of TOML tables.

    Types are not converted, instances are immutable, and unknown fields are errors.
    """

    model_config = ConfigDict(
        strict=True, extra="forbid", frozen=True, allow_inf_nan=False, hide_input_in_errors=True
    )


def validate_fields(
    model: type[Model],
    fields: Mapping[str, Any],
    shelf: str,
    name: str,
    error: type[KnifetipError] = LibraryError,
) -> Model:
    """Return the fields of a TOML document as an instance of the pydantic model ``model``.

    Parameters
    ----------
    fields
        Values by field name, as parsed from the document.
    shelf, name
        Kind of the file ("machine", "board" or "profile") and its name, for the error message.
    error
        Class of the error that is raised if the fields are invalid.

    Raises
    ------
    LibraryError
        A field is missing, invalid or unknown; ``source`` is the path of the first such field.
        If the caller gives another class as ``error``, that class is raised instead.
    """
    try:
        return model.model_validate(fields)
    except ValidationError as reason:
        # Unknown fields first: a missing field is often a misspelt one.
        faults = sorted(
            reason.errors(include_url=False), key=lambda fault: fault["type"] != "extra_forbidden"
        )
        raise error(
            "library.invalid",
            shelf=shelf,
            name=name[:200],
            faults=[field_message(model, fault) for fault in faults[:_MOST]],
            source=_field(faults[0]),
        ) from None


def _path(fault: ErrorDetails) -> tuple[str, ...]:
    """Return the path of the field that a pydantic error names: ("station 2", "tool", "tilt")."""
    path: list[str] = []
    before: int | str = ""
    for key in fault["loc"]:
        if isinstance(key, int) and path:
            path[-1] += f" {key + 1}"
        # pydantic adds the kind of a tool to the path, which is not a table of the file.
        elif before != "tool":
            path.append(str(key))
        before = key
    return tuple(path)


def _field(fault: ErrorDetails) -> tuple[str, ...]:
    """Return the path of the field that a pydantic error names.

    If the error names an item of a list, the path is that of the list, without the item's number.
    """
    path = _path(fault)
    if len(path) > 1 and isinstance(fault["loc"][-1], int):
        return (*path[:-1], path[-1].rpartition(" ")[0])
    return path


def field_error(code: str, **arguments: Any) -> PydanticCustomError:
    """Return the error that a validator of a pydantic model must raise for an invalid field.

    Parameters
    ----------
    code
        Code of the message that describes the error.
    arguments
        Arguments of the message except ``path``, which ``field_message`` adds.
    """
    return PydanticCustomError(code, code, arguments)


def field_message(model: type[BaseModel], fault: ErrorDetails) -> Message:
    """Return the message that describes an error that pydantic reports for a field of ``model``."""
    path = " → ".join(_path(fault))[:200] or "the document"
    kind, context = fault["type"], fault.get("ctx", {})
    if kind in CODES:
        return Message(kind, path=path, **context)
    if kind == "extra_forbidden":
        near = difflib.get_close_matches(str(fault["loc"][-1]), sorted(set(_names(model))), 1)
        return (
            Message("field.misspelt", path=path, near=near[0])
            if near
            else Message("field.unknown", path=path)
        )
    if kind not in _CODES:
        return Message("field.other", path=path, reason=fault["msg"])
    given = {**context, "value": repr(fault.get("input"))[:80]}
    code, named = _CODES[kind]
    return Message(code, path=path, **{name: given[key] for name, key in named.items()})


_VALUE: Final = {"value": "value"}
#: The code of each error type of pydantic, and the key of its context for each argument.
_CODES: Final[Mapping[str, tuple[str, Mapping[str, str]]]] = {
    "missing": ("field.missing", {}),
    "float_type": ("field.not-a-number", _VALUE),
    "finite_number": ("field.not-a-number", _VALUE),
    "int_type": ("field.not-whole", _VALUE),
    "int_from_float": ("field.not-whole", _VALUE),
    "bool_type": ("field.not-boolean", _VALUE),
    "string_type": ("field.not-text", _VALUE),
    "list_type": ("field.not-a-list", _VALUE),
    "tuple_type": ("field.not-a-list", _VALUE),
    "dict_type": ("field.not-a-table", _VALUE),
    "model_type": ("field.not-a-table", _VALUE),
    "model_attributes_type": ("field.not-a-table", _VALUE),
    "greater_than": ("field.not-above", {**_VALUE, "limit": "gt"}),
    "greater_than_equal": ("field.below", {**_VALUE, "limit": "ge"}),
    "less_than": ("field.not-below", {**_VALUE, "limit": "lt"}),
    "less_than_equal": ("field.above", {**_VALUE, "limit": "le"}),
    "literal_error": ("field.not-allowed", {**_VALUE, "allowed": "expected"}),
    "union_tag_not_found": ("field.no-kind", {"field": "discriminator"}),
    "union_tag_invalid": ("field.unknown-kind", {"value": "tag", "known": "expected_tags"}),
    "too_short": ("field.too-few", {"count": "actual_length", "least": "min_length"}),
    "too_long": ("field.too-many", {"most": "max_length"}),
    "string_pattern_mismatch": ("field.blank", {}),
    "string_too_long": ("field.too-long", {"most": "max_length"}),
}


def _names(model: type[BaseModel]) -> Iterator[str]:
    """Yield the names of all fields of a model and of the models of the tables in its fields."""
    schema = model.model_json_schema()
    for table in (schema, *schema.get("$defs", {}).values()):
        yield from table.get("properties", {})
