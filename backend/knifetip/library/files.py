"""files: validate the fields of TOML files.

    fields of a document, model -> validated model, or an error with the path and fault of the field

Numbers must be finite, and types are not converted.  Unknown fields are errors.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from typing import Any, TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import ErrorDetails

from knifetip.errors import KnifetipError, LibraryError
from knifetip.messages import Message

Model = TypeVar("Model", bound="Table")

#: Largest number of faults of one file in an error.
_MOST = 5


class Table(BaseModel):
    """Base class of the models of TOML tables."""

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
    """Return the validated model of a TOML document.

    Parameters
    ----------
    shelf, name
        Kind and name of the file, for the error.
    error
        Class of the error.

    Raises
    ------
    LibraryError
        A field is missing, wrong or unknown; ``source`` is the path of the first of them.
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
            faults=[_message(model, fault) for fault in faults[:_MOST]],
            source=_field(faults[0]),
        ) from None


def _path(fault: ErrorDetails) -> tuple[str, ...]:
    """Return the path of the wrong field: ("station 2", "tool", "tilt")."""
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
    """Return the path of the wrong field without the number of a value in a list of values."""
    path = _path(fault)
    if len(path) > 1 and isinstance(fault["loc"][-1], int):
        return (*path[:-1], path[-1].rpartition(" ")[0])
    return path


def _message(model: type[Table], fault: ErrorDetails) -> Message:
    """Return the message for a fault of a field."""
    path = " → ".join(_path(fault))[:200] or "the file"
    if fault["type"] == "missing":
        return Message("field.missing", path=path)
    if fault["type"] == "extra_forbidden":
        near = difflib.get_close_matches(str(fault["loc"][-1]), sorted(set(_names(model))), 1)
        return (
            Message("field.misspelt", path=path, near=near[0])
            if near
            else Message("field.unknown", path=path)
        )
    return Message("field.invalid", path=path, fault=_text(fault))


#: Text of each error type of pydantic, formatted with the input and the context of the error.
_TEXTS = {
    "float_type": "is {input}, not a number",
    "int_type": "is {input}, not a whole number",
    "int_from_float": "is {input}, not a whole number",
    "finite_number": "is {input}, not a number",
    "bool_type": "is {input}, not true or false",
    "string_type": "is {input}, not text",
    "list_type": "is {input}, not a list",
    "tuple_type": "is {input}, not a list",
    "dict_type": "is {input}, not a table",
    "model_type": "is {input}, not a table",
    "model_attributes_type": "is {input}, not a table",
    "greater_than": "is {input}, but must be greater than {gt:g}",
    "greater_than_equal": "is {input}, but must be at least {ge:g}",
    "less_than": "is {input}, but must be less than {lt:g}",
    "less_than_equal": "is {input}, but must be at most {le:g}",
    "literal_error": "is {input}, but must be {expected}",
    "union_tag_not_found": "has no {discriminator}",
    "union_tag_invalid": "has the unknown kind {tag!r}; known kinds are {expected_tags}",
    "too_short": "has {actual_length} values, but needs at least {min_length}",
    "too_long": "has more than {max_length} values",
    "string_pattern_mismatch": "is {input}, but must contain visible characters",
    "string_too_long": "is longer than {max_length} characters",
    "value_error": "{error}",
}


def _text(fault: ErrorDetails) -> str:
    """Return the text of a fault, that of pydantic for unlisted error types."""
    text = _TEXTS.get(fault["type"])
    if text is None:
        return fault["msg"]
    return text.format(**{"input": repr(fault["input"])[:80], **fault.get("ctx", {})})


def _names(model: type[BaseModel]) -> Iterator[str]:
    """Yield the names of all fields of a model and of its tables."""
    schema = model.model_json_schema()
    for table in (schema, *schema.get("$defs", {}).values()):
        yield from table.get("properties", {})
