"""options: allow dataclasses as parameters of commands, to group command-line options.

Typer creates one option from each parameter of a function.  ``expand`` converts a function with
dataclass parameters to a function with one parameter for each field of the dataclasses.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import MISSING, Field, fields, is_dataclass
from typing import Any, get_type_hints


def expand(command: Callable[..., None]) -> Callable[..., None]:
    """Return a function for Typer that calls ``command`` but has no dataclass parameters.

    Each dataclass parameter of ``command`` is replaced by one parameter for each of its fields.

    Parameters
    ----------
    command
        Function whose parameters have types that Typer supports, or are dataclasses with fields of
        such types.  The returned function creates the dataclass instances and calls ``command``.
    """
    hints = get_type_hints(command, include_extras=True)
    records: dict[str, tuple[Callable[..., Any], list[str]]] = {}
    parameters = []
    for name, parameter in inspect.signature(command).parameters.items():
        kind = hints[name]
        if not (isinstance(kind, type) and is_dataclass(kind)):
            parameters.append(parameter.replace(annotation=kind, kind=parameter.KEYWORD_ONLY))
            continue
        types = get_type_hints(kind, include_extras=True)
        records[name] = (kind, [field.name for field in fields(kind)])
        parameters += [_parameter(field, types[field.name]) for field in fields(kind)]

    def call(**values: Any) -> None:
        for name, (kind, names) in records.items():
            values[name] = kind(**{each: values.pop(each) for each in names})
        command(**values)

    call.__name__, call.__doc__ = command.__name__, command.__doc__
    call.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]  # typer reads it
    call.__annotations__ = {each.name: each.annotation for each in parameters}
    return call


def _parameter(field: Field[Any], kind: Any) -> inspect.Parameter:
    """Return a keyword-only parameter that has the name and the default value of a field.

    ``expand`` adds it to the signature of a command.

    Parameters
    ----------
    field
        Field of a dataclass.
    kind
        Type annotation of the field.
    """
    default = inspect.Parameter.empty if field.default is MISSING else field.default
    return inspect.Parameter(
        field.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=kind
    )
