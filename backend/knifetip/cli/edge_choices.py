"""Command-line syntax of options of a job that concern some edges: EDGES:NAME=VALUE,NAME=VALUE.

EDGES are numbers of edges, or the name of a line type if the option has one.

The names and the help come from the fields of the option, so an option of this kind needs no code
here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, get_args

from knifetip.cli.check_option import check_option
from knifetip.errors import PlanError
from knifetip.model.edge_choice import EdgeChoice, LineTypeChoice


def edge_choice_of(annotation: Any) -> type[EdgeChoice] | None:
    """Return the class of the choices in a field of this type; None if it has no such choices."""
    kinds = [kind for kind in get_args(annotation) if isinstance(kind, type)]
    return next((kind for kind in kinds if issubclass(kind, EdgeChoice)), None)


def edge_choice_help(kind: type[EdgeChoice], description: str) -> str:
    """Return the help of an option for choices of edges, with the names that its syntax has."""
    parts = "; ".join(
        f"{name}: {one.description}"
        for name, one in kind.model_fields.items()
        if name not in LineTypeChoice.model_fields
    )
    words = ", or a line type: cut" if issubclass(kind, LineTypeChoice) else ""
    return f"{description}. EDGES are numbers of edges: 3,4{words}. {parts}. May be repeated."


def parse_edge_choices(
    kind: type[EdgeChoice], name: str, texts: Sequence[str] | None
) -> tuple[EdgeChoice, ...]:
    """Return the choices that the values of an option describe.

    Parameters
    ----------
    kind
        Class of the choices.
    name
        Name of the option, for errors.
    texts
        The values, each ``EDGES:NAME=VALUE,NAME=VALUE``; None if the option is not given.

    Raises
    ------
    PlanError
        A value does not have this form, or a field has an invalid value.
    """
    return tuple(_parse(kind, name, text) for text in texts or ())


def _parse(kind: type[EdgeChoice], name: str, text: str) -> EdgeChoice:
    """Return the choice that one value of an option describes."""
    edges, _, rest = text.partition(":")
    pairs = [part.partition("=") for part in rest.split(",")]
    fields: dict[str, Any]
    if issubclass(kind, LineTypeChoice) and not edges[:1].isdigit():
        fields = {"line_type": edges.strip()}
    else:
        try:
            fields = {"edges": tuple(int(row) for row in edges.split(","))}
        except ValueError:
            raise PlanError("edge-choice.bad-syntax", option=name, text=text) from None
    if not all(separator for _, separator, _ in pairs):
        raise PlanError("edge-choice.bad-syntax", option=name, text=text)
    fields |= {field.strip(): _value(value.strip()) for field, _, value in pairs}
    return check_option(kind, f"{name} {text}", fields)


def _value(text: str) -> int | float | str:
    """Return a value of the command line as a number if it is one."""
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            continue
    return text
