"""Describe the invalid fields of a request: one message with the faults, and their paths."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Final, TypeAlias, cast

from pydantic_core import ErrorDetails

from knifetip.fields import Place, fault_message
from knifetip.messages import Message

#: Returns the names that a parameter or field at a place may have, to suggest one of them.
NamesNear: TypeAlias = Callable[[Place], Sequence[str]]

#: Fields of forms that have parts with names: JSON, and a file with its name.
_WITH_PARTS: Final = ("metadata", "file")
#: Largest number of faults in a message, and of paths.
_MOST: Final = 5
_MOST_PATHS: Final = 20


def invalid_request(
    faults: Sequence[ErrorDetails], names: NamesNear, is_form: bool = False
) -> tuple[Message, list[str]]:
    """Return the message about the invalid fields of a request, and their paths.

    Parameters
    ----------
    faults
        Errors of pydantic, with paths that begin with the part of the request, such as ``body``.
    names
        Returns the names that a parameter or field at a place may have.
    is_form
        Whether the body of the request is a form.
    """
    without_types = [_without_types(fault, is_form) for fault in faults]
    # pydantic reports a value once for each of the types that its field may have.
    found = list({fault["loc"]: fault for fault in reversed(without_types)}.values())[::-1]
    paths = [".".join(str(step) for step in fault["loc"])[:200] for fault in found[:_MOST_PATHS]]
    messages = [
        fault_message(fault, path, partial(names, fault["loc"]))
        for fault, path in zip(found[:_MOST], paths, strict=False)
    ]
    return Message("request.invalid", faults=messages), paths


def _without_types(fault: ErrorDetails, is_form: bool) -> ErrorDetails:
    """Return an error of pydantic whose path contains no name of a type.

    pydantic adds one where a field may have several types.  Parameters and the fields of forms have
    no fields of their own, except ``_WITH_PARTS``.
    """
    place, name, *inner = (*fault["loc"], "", "")[: max(len(fault["loc"]), 2)]
    if (place == "body" and not is_form) or name in _WITH_PARTS:
        return fault
    steps = (step for step in inner if isinstance(step, int))
    return {**fault, "loc": (place, *((name,) if name != "" else ()), *steps)}


def with_line(fault: Any, body: object) -> ErrorDetails:
    """Return an error of pydantic; one of the JSON parser gets the line and the column.

    FastAPI places it by the number of the character, which is no path, with Python's own words.
    """
    loc = fault["loc"]
    if fault["type"] != "json_invalid" or not isinstance(loc[-1], int):
        return cast("ErrorDetails", fault)
    before = (body if isinstance(body, str) else "")[: loc[-1]]
    line = before.count("\n") + 1
    column = len(before) - before.rfind("\n")
    place = {"line": line, "column": column}
    moved = {**fault, "type": "field.bad-json", "loc": loc[:-1], "ctx": place}
    return cast("ErrorDetails", moved)
