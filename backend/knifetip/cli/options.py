"""options: allow records as parameters of commands, to group command-line options.

Typer creates one option from each parameter of a function.  ``expand`` converts a function with
records as parameters to a function with one parameter for each of their fields.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, fields, is_dataclass
from enum import Enum
from functools import partial
from typing import Annotated, Any, get_type_hints

import typer

from knifetip.cli.edge_choices import edge_choice_help, edge_choice_of, parse_edge_choices
from knifetip.fields import Table
from knifetip.model.edge_choice import EdgeChoice

_NO_SYNTAX: Mapping[str, type] = {}


def expand(
    command: Callable[..., None], syntax: Mapping[str, type] = _NO_SYNTAX
) -> Callable[..., None]:
    """Return a function for Typer that calls ``command`` but has no records as parameters.

    Each parameter of ``command`` that is a record is replaced by one parameter for each of its
    fields.

    Parameters
    ----------
    command
        Function whose parameters have types that Typer supports, or are records: dataclasses with
        fields of such types, tables of ``knifetip.fields``, or settings of a process; fields of
        tables and settings must have descriptions.  The returned function creates the records and
        calls ``command``.
    syntax
        Fields of tables with several options or a syntax of their own: for each a dataclass with a
        method ``record``, which returns the value of the field.
    """
    hints = get_type_hints(command, include_extras=True)
    records: dict[str, Callable[[dict[str, Any]], Any]] = {}
    parameters: list[inspect.Parameter] = []
    for name, parameter in inspect.signature(command).parameters.items():
        kind = hints[name]
        if isinstance(kind, type) and issubclass(kind, Table):
            records[name], found = _model(kind, syntax)
            parameters += found
        elif _is_settings(kind):
            records[name], found = _settings(kind)
            parameters += found
        elif isinstance(kind, type) and is_dataclass(kind):
            records[name], found = _dataclass(kind)
            parameters += found
        else:
            parameters.append(parameter.replace(annotation=kind, kind=parameter.KEYWORD_ONLY))

    def call(**values: Any) -> None:
        for name, build in records.items():
            values[name] = build(values)
        command(**values)

    call.__name__, call.__doc__ = command.__name__, command.__doc__
    call.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]  # typer reads it
    call.__annotations__ = {each.name: each.annotation for each in parameters}
    return call


def _dataclass(
    kind: type,
) -> tuple[Callable[[dict[str, Any]], Any], list[inspect.Parameter]]:
    """Return a function that takes the fields of a dataclass out of given values and creates the
    instance, and the parameters for the fields.
    """
    types = get_type_hints(kind, include_extras=True)
    names = [field.name for field in fields(kind)]
    parameters = [
        _parameter(
            field.name,
            types[field.name],
            inspect.Parameter.empty if field.default is MISSING else field.default,
        )
        for field in fields(kind)
    ]
    return lambda values: kind(**{name: values.pop(name) for name in names}), parameters


def _model(
    kind: type[Table], syntax: Mapping[str, type]
) -> tuple[Callable[[dict[str, Any]], Any], list[inspect.Parameter]]:
    """Return a function that takes the fields of a table out of given values and creates
    the instance, and the parameters for the fields.
    """
    builders: dict[str, Callable[[dict[str, Any]], Any]] = {}
    parameters: list[inspect.Parameter] = []
    for name, field in kind.model_fields.items():
        if name in syntax:
            build, found = _dataclass(syntax[name])
            builders[name] = partial(_take_record, build)
            parameters += found
        elif (choice := edge_choice_of(field.annotation)) is not None:
            builders[name] = partial(_take_choices, choice, name)
            parameters.append(_choices_parameter(choice, name, f"{field.description}"))
        else:
            builders[name] = partial(_take_value, name)
            option = typer.Option(help=f"{field.description}.", **_limits(field.metadata))
            default = inspect.Parameter.empty if field.is_required() else field.default
            parameters.append(_parameter(name, Annotated[field.annotation, option], default))

    def build_record(values: dict[str, Any]) -> Table:
        return kind(**{name: build(values) for name, build in builders.items()})

    return build_record, parameters


def _is_settings(kind: Any) -> bool:
    """Return whether a type is a class of settings; without such a class, their library is not
    imported.
    """
    library = sys.modules.get("pydantic_settings")
    return library is not None and isinstance(kind, type) and issubclass(kind, library.BaseSettings)


def _settings(
    kind: Any,
) -> tuple[Callable[[dict[str, Any]], Any], list[inspect.Parameter]]:
    """Return a function that takes given settings out of values and adds those of the settings
    file, and the parameters for the settings.
    """
    from knifetip.service.settings import FileOnly, load_settings

    own = [name for name in kind.__annotations__ if name in kind.model_fields]
    names = [
        name
        for name in dict.fromkeys((*own, *kind.model_fields))
        if not any(isinstance(one, FileOnly) for one in kind.model_fields[name].metadata)
    ]

    def build_settings(values: dict[str, Any]) -> Any:
        found = {name: values.pop(name) for name in names}
        return load_settings(
            kind, **{name: value for name, value in found.items() if value is not None}
        )

    return build_settings, [_setting(name, kind.model_fields[name]) for name in names]


def _setting(name: str, field: Any) -> inspect.Parameter:
    """Return the parameter of a setting; its value is None if the option is not given."""
    from knifetip.service.settings import PREFIX, FormerName

    former = [one.name for one in field.metadata if isinstance(one, FormerName)]
    words = [each.replace("_", "-") for each in (name, *former)]
    default = field.default.value if isinstance(field.default, Enum) else field.default
    if field.annotation is bool:
        flags = [f"--{word}/--no-{word}" for word in words]
        default = words[0] if default else f"no-{words[0]}"
    else:
        flags = [f"--{word}" for word in words]
    stated = "" if default in (None, "", ()) else f" Default: {default}."
    option = typer.Option(
        *flags,
        envvar=[PREFIX + each.upper() for each in (name, *former)],
        help=f"{field.description}.{stated}",
        **_limits(field.metadata),
    )
    kind = list[str] if field.annotation == tuple[str, ...] else field.annotation
    return _parameter(name, Annotated[kind | None, option], None)


def _take_record(build: Callable[[dict[str, Any]], Any], values: dict[str, Any]) -> Any:
    return build(values).record()


def _choices_parameter(choice: type[EdgeChoice], name: str, description: str) -> inspect.Parameter:
    """Return the parameter of an option for choices of edges."""
    option = typer.Option(metavar="EDGES:NAME=VALUE,…", help=edge_choice_help(choice, description))
    return _parameter(name, Annotated[list[str] | None, option], None)


def _take_choices(choice: type[EdgeChoice], name: str, values: dict[str, Any]) -> Any:
    return parse_edge_choices(choice, f"--{name.replace('_', '-')}", values.pop(name))


def _take_value(name: str, values: dict[str, Any]) -> Any:
    return values.pop(name)


def _limits(metadata: Sequence[Any]) -> dict[str, Any]:
    """Return the least and the greatest value in the metadata of a field, as arguments of
    ``typer.Option``.
    """
    found = {"min": "ge", "max": "le"}
    return {
        argument: getattr(one, name)
        for one in metadata
        for argument, name in found.items()
        if hasattr(one, name)
    }


def _parameter(name: str, kind: Any, default: Any) -> inspect.Parameter:
    """Return a keyword-only parameter."""
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=kind)
