"""files: TOML of the user's own, checked field by field.

    fields of a document, model -> the checked model, or an error that names field, fault and hint

Numbers are finite, and no other type is taken for one; a field that means nothing is an error.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from typing import Any, TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import ErrorDetails

from knifetip.errors import KnifetipError, LibraryError
from knifetip.messages import Message

File = TypeVar("File", bound="Table")

#: So many faults of one file are listed.
_MOST = 5


class Table(BaseModel):
    """A table of a TOML document."""

    model_config = ConfigDict(
        strict=True, extra="forbid", frozen=True, allow_inf_nan=False, hide_input_in_errors=True
    )


def checked(
    model: type[File],
    fields: Mapping[str, Any],
    shelf: str,
    name: str,
    error: type[KnifetipError] = LibraryError,
) -> File:
    """Return the fields of a document as a model.

    Parameters
    ----------
    shelf, name
        What the file describes, and its name, for the error.
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
        # Beside a missing field a misspelt one is what to look at.
        faults = sorted(
            reason.errors(include_url=False), key=lambda fault: fault["type"] != "extra_forbidden"
        )
        raise error(
            "library.invalid",
            shelf=shelf,
            name=name[:200],
            faults=[_message(model, fault) for fault in faults[:_MOST]],
            source=_path(faults[0]),
        ) from None


def _path(fault: ErrorDetails) -> tuple[str, ...]:
    """Return the tables and the field that a fault is in: ("station 2", "tool", "tilt")."""
    path: list[str] = []
    before: int | str = ""
    for key in fault["loc"]:
        if isinstance(key, int) and path:
            path[-1] += f" {key + 1}"
        # Below a tool pydantic names its kind, which is no table of the file.
        elif before != "tool":
            path.append(str(key))
        before = key
    return tuple(path)


def _message(model: type[Table], fault: ErrorDetails) -> Message:
    """Return what is wrong with a field."""
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


#: What is wrong, by pydantic's type of error; the limits of an error fill in the braces.
_TEXTS = {
    "float_type": "is {input}, not a number",
    "int_type": "is {input}, not a whole number",
    "int_from_float": "is {input}, not a whole number",
    "finite_number": "is {input}, not a number",
    "bool_type": "is {input}: it is true or false",
    "string_type": "is {input}, not text",
    "list_type": "is {input}, not a list",
    "tuple_type": "is {input}, not a list",
    "dict_type": "is {input}, not a table",
    "model_type": "is {input}, not a table",
    "model_attributes_type": "is {input}, not a table",
    "greater_than": "is {input}, and must be more than {gt:g}",
    "greater_than_equal": "is {input}, and must not be less than {ge:g}",
    "less_than": "is {input}, and must be less than {lt:g}",
    "less_than_equal": "is {input}, and must not be more than {le:g}",
    "literal_error": "is {input}: it is {expected}",
    "union_tag_not_found": "has no {discriminator}",
    "union_tag_invalid": "is of kind {tag!r}, which there is not; there are {expected_tags}",
    "too_short": "has {actual_length} values, and must have {min_length} or more",
    "too_long": "has too many values: it may have {max_length}",
    "string_pattern_mismatch": "is {input}, which says nothing",
    "string_too_long": "is longer than {max_length} characters",
    "value_error": "{error}",
}


def _text(fault: ErrorDetails) -> str:
    text = _TEXTS.get(fault["type"])
    if text is None:
        return fault["msg"]
    return text.format(**{"input": repr(fault["input"])[:80], **fault.get("ctx", {})})


def _names(model: type[BaseModel]) -> Iterator[str]:
    """Yield the names of all fields of a model and of the tables in it."""
    schema = model.model_json_schema()
    for table in (schema, *schema.get("$defs", {}).values()):
        yield from table.get("properties", {})
