"""fields: validate the fields of TOML files and requests against pydantic models.

``check_fields`` returns a validated model, or raises an error with one message for each invalid
field: its path and the fault.  Numbers must be finite, and types are not converted.  Unknown fields
are errors.
"""

from __future__ import annotations

import difflib
import json
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Final, TypeAlias, TypeVar, get_args

from pydantic import BaseModel, ConfigDict, GetCoreSchemaHandler, ValidationError
from pydantic_core import ErrorDetails, PydanticCustomError, core_schema

from knifetip.messages import Message
from knifetip.messages.characters import TextKind, control_character, printable
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


class PartTable(Table):
    """Base class of the pydantic models of tables that are parts of others.

    The validator of such a model is built when it is first used by itself, which is rarely so.
    """

    model_config = ConfigDict(defer_build=True)


#: Fields with names in drawings, as they were read: of layers, blocks and the like.
QUOTED_FIELDS: Final[Mapping[str, TextKind]] = dict.fromkeys(
    ("block", "entity", "handles", "layer", "linetype"), TextKind.QUOTED
)
#: Path of a value in a document: names of fields, and places in lists from 0.
Place: TypeAlias = tuple[str | int, ...]


def control_characters(
    value: object,
    place: Place,
    kinds: Mapping[str, TextKind],
    kind: TextKind = TextKind.LINE,
) -> Iterator[tuple[Place, str]]:
    """Yield the path and the name of a control character for each text that has one.

    Parameters
    ----------
    value
        A text, or a list or an object with texts as values or names.
    place
        Path of the value.
    kinds
        What the texts in fields with these names may contain.
    kind
        What the texts in other fields may contain.
    """
    if isinstance(value, str):
        if found := control_character(value, kind):
            yield place, found
    elif isinstance(value, Mapping):
        for name, inner in value.items():
            shown = printable(str(name))
            if found := control_character(str(name), TextKind.LINE):
                yield (*place, shown), found
            yield from control_characters(inner, (*place, shown), kinds, kinds.get(name, kind))
    elif isinstance(value, list):
        for order, inner in enumerate(value):
            if not isinstance(inner, int | float):
                yield from control_characters(inner, (*place, order), kinds, kind)


class InvalidFields(Exception):
    """Raised when fields of a TOML document are invalid.

    The caller raises an error that also names the document.

    Attributes
    ----------
    faults
        One message per fault, with the path of the field.
    source
        Path of the field that the first message concerns.
    """

    def __init__(self, faults: Sequence[Message], source: Sequence[str]) -> None:
        super().__init__("; ".join(map(str, faults)))
        self.faults = tuple(faults)
        self.source = tuple(source)


def check_fields(model: type[Model], fields: Mapping[str, Any]) -> Model:
    """Return the fields of a TOML document as an instance of the pydantic model ``model``.

    ``fields`` contains the values by field name, as parsed from the document.

    Raises
    ------
    InvalidFields
        A field is missing, invalid or unknown.
    """
    for place, character in control_characters(fields, (), QUOTED_FIELDS, TextKind.LINES):
        path = tuple(str(step) for step in place)
        message = Message(
            "field.control-character", path=" → ".join(path)[:200], character=character
        )
        raise InvalidFields([message], path)
    try:
        return model.model_validate(fields)
    except ValidationError as reason:
        # Unknown fields first: a missing field is often a misspelt one.
        faults = sorted(
            reason.errors(include_url=False), key=lambda fault: fault["type"] != "extra_forbidden"
        )
        messages = [field_message(model, fault) for fault in faults[:_MOST]]
        raise InvalidFields(messages, _field(faults[0])) from None


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
    """Return the path of the field that a pydantic error names, without the index of a list item.

    If the error names an item of a list, the result is the path of the list.
    """
    path = _path(fault)
    if len(path) > 1 and isinstance(fault["loc"][-1], int):
        return (*path[:-1], path[-1].rpartition(" ")[0])
    return path


def field_error(code: str, **arguments: Any) -> PydanticCustomError:
    """Return the error that a validator of a pydantic model raises for an invalid field.

    Parameters
    ----------
    code
        Code of the message that describes the error.
    arguments
        Values by name that are inserted into the message.  Two more are added when the message is
        written: the path of the field and, unless ``arguments`` contains a value, the value of the
        field.
    """
    return PydanticCustomError(code, code, arguments)


class _ListedValues:
    """Annotation for a field whose type is a Literal or an enumeration.

    If the value of the field is invalid, the error message lists the permitted values.
    """

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        values = get_args(source) or tuple(source)
        return core_schema.custom_error_schema(
            handler(source),
            custom_error_type="field.not-one-of",
            custom_error_message="field.not-one-of",
            custom_error_context={"known": [repr(str(value)) for value in values]},
        )


#: Annotation of a Literal or an enumeration: the error of any other value lists the values.
LISTED: Final = _ListedValues()


def field_message(model: type[BaseModel], fault: ErrorDetails) -> Message:
    """Return the message that describes an error that pydantic reports for a field of ``model``."""
    path = " → ".join(_path(fault))[:200] or "body"
    return fault_message(fault, path, lambda: sorted(set(_names(model))))


def fault_message(
    fault: ErrorDetails, path: str, names: Callable[[], Sequence[str]] = tuple
) -> Message:
    """Return the message that describes an error that pydantic reports for a field.

    Parameters
    ----------
    fault
        The error.
    path
        Path of the field, as text for the message.
    names
        Function that returns the names of all permitted fields.  If the field is unknown, the
        message suggests the most similar of these names.
    """
    kind, context = _kind(fault), fault.get("ctx", {})
    if kind in CODES:
        given = {"value": _shown_value(fault), **context, "path": path}
        return Message(kind, **{name: given[name] for name in CODES[kind]})
    if kind == "extra_forbidden":
        near = difflib.get_close_matches(str(fault["loc"][-1]), names(), 1)
        return (
            Message("field.misspelt", path=path, near=near[0])
            if near
            else Message("field.unknown", path=path)
        )
    if kind not in _CODES:
        return Message("field.other", path=path, value=_shown_value(fault), fault=kind)
    if kind == "union_tag_invalid":
        path += f".{str(context['discriminator']).strip(chr(39))}"
    given = {
        **context,
        "value": _shown_value(fault),
        "known": _QUOTED.findall(str(context.get("expected", context.get("expected_tags", "")))),
    }
    code, named = _CODES[kind]
    return Message(code, path=path, **{name: given[key] for name, key in named.items()})


def _kind(fault: ErrorDetails) -> str:
    """Return the kind of an error; texts that are too short or too long have kinds of their own."""
    kind = fault["type"]
    if kind in ("too_short", "too_long") and isinstance(fault.get("input"), str):
        return f"string_{kind}"
    return kind


def _shown_value(fault: ErrorDetails) -> str:
    """Return the value that a pydantic error concerns, shortened, as text."""
    if fault["type"] == "union_tag_invalid":
        return repr(fault["ctx"]["tag"])[:80]
    return value_text(fault.get("input"))


def value_text(value: Any) -> str:
    """Return a value as text for a message, shortened: in the words of JSON, not of Python."""
    if isinstance(value, str):
        return repr(value)[:80]
    if isinstance(value, bytes):
        return f"{len(value)} bytes"
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)  # as TOML spells it; JSON has no such number
    try:
        return json.dumps(value, ensure_ascii=False, default=str)[:80]
    except (ValueError, RecursionError):
        return "a nested value"


_VALUE: Final = {"value": "value"}
_QUOTED: Final = re.compile(r"'[^']*'")
#: The code of each error type of pydantic, and the key of its context for each argument.
_CODES: Final[Mapping[str, tuple[str, Mapping[str, str]]]] = {
    "missing": ("field.missing", {}),
    "enum": ("field.not-one-of", {**_VALUE, "known": "known"}),
    "literal_error": ("field.not-one-of", {**_VALUE, "known": "known"}),
    "union_tag_invalid": ("field.not-one-of", {**_VALUE, "known": "known"}),
    "string_pattern_mismatch": ("field.wrong-form", _VALUE),
    "string_unicode": ("field.not-text", _VALUE),
    "dataclass_type": ("field.not-a-table", _VALUE),
    "mapping_type": ("field.not-a-table", _VALUE),
    "set_type": ("field.not-a-list", _VALUE),
    "float_from_int": ("field.not-a-number", _VALUE),
    "int_parsing_size": ("field.not-whole", _VALUE),
    "none_required": ("field.not-empty", _VALUE),
    "float_type": ("field.not-a-number", _VALUE),
    "finite_number": ("field.not-a-number", _VALUE),
    "int_type": ("field.not-whole", _VALUE),
    "int_from_float": ("field.not-whole", _VALUE),
    "int_parsing": ("field.not-whole", _VALUE),
    "float_parsing": ("field.not-a-number", _VALUE),
    "bool_parsing": ("field.not-boolean", _VALUE),
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
    "union_tag_not_found": ("field.no-kind", {"field": "discriminator"}),
    "json_invalid": ("field.not-json", {"reason": "error"}),
    "too_short": ("field.too-few", {"count": "actual_length", "least": "min_length"}),
    "too_long": ("field.too-many", {"most": "max_length"}),
    "string_too_short": ("field.too-short", {"least": "min_length"}),
    "string_too_long": ("field.too-long", {"most": "max_length"}),
}


def _names(model: type[BaseModel]) -> Iterator[str]:
    """Yield the names of all fields of a model and of the models of the tables in its fields."""
    schema = model.model_json_schema()
    for table in (schema, *schema.get("$defs", {}).values()):
        yield from table.get("properties", {})
