"""load: machines, boards and profiles by name, or from a TOML file of the user's own.

"demo-table" -> Machine        "e-flute" -> Board        "default" -> LineRules
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Mapping
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any, TypeVar

from knifetip.errors import LibraryError, ProfileError
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine import Axis, Machine, Station
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Tool, VCutter

Made = TypeVar("Made")

_TOOLS: dict[str, type[Knife] | type[CreaseWheel] | type[VCutter] | type[Cutter]] = {
    "knife": Knife,
    "crease-wheel": CreaseWheel,
    "v-cutter": VCutter,
    "cutter": Cutter,
}


def kind_of(tool: Tool) -> str:
    """Return the library's word for a tool: knife, crease-wheel, v-cutter or cutter."""
    return next(word for word, cls in _TOOLS.items() if cls is type(tool))


def names(shelf: str) -> list[str]:
    """Return the names on a shelf: ``machines``, ``boards`` or ``profiles``."""
    folder = resources.files(__package__) / shelf
    return sorted(
        entry.name.removesuffix(".toml")
        for entry in folder.iterdir()
        if entry.name.endswith(".toml")
    )


@cache
def machine(name: str) -> Machine:
    """Return a machine of the library, or of a TOML file.

    Raises
    ------
    LibraryError
        There is no such machine, or its file is wrong.
    """
    return _made("machines", "machine", name, parse_machine)


@cache
def board(name: str) -> Board:
    """Return a board of the library, or of a TOML file.

    Raises
    ------
    LibraryError
        There is no such board, or its file is wrong.
    """
    return _made("boards", "board", name, parse_board)


@cache
def profile(name: str) -> LineRules:
    """Return a classification profile of the library, or of a TOML file.

    Raises
    ------
    LibraryError, ProfileError
        There is no such profile, or its file is wrong.
    """
    return _made("profiles", "profile", name, parse_profile)


def _made(
    shelf: str, word: str, name: str, parse: Callable[[str, Mapping[str, Any]], Made]
) -> Made:
    known = names(shelf)
    if name in known:
        text = (resources.files(__package__) / shelf / f"{name}.toml").read_text("utf-8")
        stem = name
    elif name.endswith(".toml") and Path(name).is_file():
        text = Path(name).read_text("utf-8")
        stem = Path(name).stem
    else:
        raise LibraryError(f"There is no {word} {name!r}.", f"There are {', '.join(known)}.")
    try:
        return parse(stem, tomllib.loads(text))
    except (tomllib.TOMLDecodeError, KeyError, TypeError, ValueError) as reason:
        failure = ProfileError if shelf == "profiles" else LibraryError
        detail = f"{reason.args[0]!r} is missing" if isinstance(reason, KeyError) else str(reason)
        raise failure(
            f"The {word} {name!r} cannot be read: {detail}.", "Mend its TOML."
        ) from reason


def _number(value: Any, name: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ValueError(f"{name} is {value!r}, not a number")
    return float(value)


def _positive(value: Any, name: str) -> float:
    number = _number(value, name)
    if number <= 0:
        raise ValueError(f"{name} is {number}, and must be more than 0")
    return number


def parse_tool(fields: Mapping[str, Any]) -> Tool:
    """Return the tool of a TOML table with ``kind`` and its dimensions."""
    rest = {key: value for key, value in fields.items() if key != "kind"}
    kind = fields["kind"]
    if kind not in _TOOLS:
        raise ValueError(f"{kind!r} is not a tool; there are {', '.join(_TOOLS)}")
    for key, value in rest.items():
        if not isinstance(value, bool):
            rest[key] = _number(value, key)
    for key in ("radius", "width", "back", "feed", "plunge"):
        if key in rest:
            _positive(rest[key], key)
    if kind == "v-cutter" and not 0 < rest["tilt"] < 90:
        raise ValueError(f"tilt is {rest['tilt']}, and must lie between 0 and 90 degrees")
    if kind == "knife" and not 0 <= rest["blade_angle"] < 80:
        raise ValueError(f"blade_angle is {rest['blade_angle']}, and must lie in 0 … 80 degrees")
    return _TOOLS[kind](**rest)


def parse_machine(name: str, fields: Mapping[str, Any]) -> Machine:
    """Return the machine of a TOML document."""
    axes = {
        axis: Axis(
            **{key: _number(fields["axes"][axis][key], f"{axis}.{key}") for key in Axis.__slots__}
        )
        for axis in "xyzc"
    }
    stations = tuple(
        Station(
            number=int(row["number"]),
            name=str(row["name"]),
            tool=parse_tool(row["tool"]),
            **{axis: _number(row["datum"][axis], f"datum.{axis}") for axis in "xyzc"},
            output=int(row.get("output", -1)),
        )
        for row in fields["station"]
    )
    numbers = [station.number for station in stations]
    if len(set(numbers)) != len(numbers) or not all(0 < number < 256 for number in numbers):
        raise ValueError(f"station numbers {numbers} must differ and lie in 1 … 255")
    return Machine(
        name=name,
        title=str(fields["title"]),
        width=_positive(fields["width"], "width"),
        height=_positive(fields["height"], "height"),
        **axes,
        stations=stations,
        dialect=str(fields["dialect"]),
        origin=(
            _number(fields["origin"][0], "origin x"),
            _number(fields["origin"][1], "origin y"),
        ),
        travel_z=_positive(fields["travel_z"], "travel_z"),
        clearance=_positive(fields["clearance"], "clearance"),
        into_mat=_number(fields["into_mat"], "into_mat"),
        settle=_number(fields["settle"], "settle"),
    )


def parse_board(name: str, fields: Mapping[str, Any]) -> Board:
    """Return the board of a TOML document."""
    caliper = _positive(fields["caliper"], "caliper")
    depths = {
        key: _positive(fields[key], key)
        for key in ("crease_along", "crease_across", "groove_depth", "half_cut_depth")
    }
    for key, depth in depths.items():
        if depth >= caliper:
            raise ValueError(f"{key} is {depth}, and must be less than the caliper {caliper}")
    if fields["short_crease"] not in ("press", "refuse"):
        raise ValueError(f"short_crease is {fields['short_crease']!r}: it is press or refuse")
    cut, gap = fields["perforation"]
    return Board(
        name=name,
        title=str(fields["title"]),
        material=str(fields["material"]),
        caliper=caliper,
        grain=_number(fields["grain"], "grain"),
        **depths,
        end_clearance=_number(fields["end_clearance"], "end_clearance"),
        groove_overcut=_number(fields["groove_overcut"], "groove_overcut"),
        perforation=(_positive(cut, "perforation cut"), _positive(gap, "perforation gap")),
        short_crease=fields["short_crease"],
    )


def parse_profile(name: str, fields: Mapping[str, Any]) -> LineRules:
    """Return the profile of a TOML document: a title and a list of ``[[rule]]``."""

    def texts(row: Mapping[str, Any], key: str) -> tuple[str, ...]:
        value = row.get(key, [])
        listed = [value] if isinstance(value, str) else value
        if not all(isinstance(item, str) for item in listed):
            raise ValueError(f"{key} must be text, not {value!r}")
        return tuple(listed)

    rules = []
    for number, row in enumerate(fields["rule"], 1):
        unknown = set(row) - {"type", "layer", "colour", "linetype", "entity"}
        if unknown:
            raise ValueError(
                f"rule {number} has {', '.join(sorted(unknown))}, which is no condition"
            )
        colour = row.get("colour", [])
        rules.append(
            LineRule(
                line_type=LineType.of(row["type"]),
                layer=texts(row, "layer"),
                colour=tuple([colour] if isinstance(colour, int) else colour),
                linetype=texts(row, "linetype"),
                entity=texts(row, "entity"),
            )
        )
    return LineRules(name, str(fields["title"]), tuple(rules))
