"""load: machines, boards and profiles by name, or from a TOML file of the user's own.

"demo-table" -> Machine        "e-flute" -> Board        "default" -> LineRules
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Mapping
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, TypeVar

from knifetip.errors import LibraryError, ProfileError
from knifetip.model.board import Board, Deflection
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

#: More passes along one groove than this, or bridges nearer than this (mm), are a slip of the pen.
_MOST_PASSES = 50
_LEAST_SPACING = 10.0


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
    file: Path | Traversable
    if name in known:
        file = resources.files(__package__) / shelf / f"{name}.toml"
    elif name.endswith(".toml"):
        file = Path(name)
    else:
        raise LibraryError(f"There is no {word} {name!r}.", f"There are {', '.join(known)}.")
    failure = ProfileError if shelf == "profiles" else LibraryError
    try:
        return parse(file.name.removesuffix(".toml"), tomllib.loads(file.read_text("utf-8")))
    except OSError as reason:
        raise LibraryError(
            f"There is no {word} {name!r}: {reason.strerror}.", f"There are {', '.join(known)}."
        ) from reason
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError) as reason:
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


def _not_negative(value: Any, name: str) -> float:
    number = _number(value, name)
    if number < 0:
        raise ValueError(f"{name} is {number}, and must not be less than 0")
    return number


def _whole(value: Any, name: str) -> int:
    number = _number(value, name)
    if not number.is_integer():
        raise ValueError(f"{name} is {number}, not a whole number")
    return int(number)


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
    if kind == "cutter":
        for key in ("speed", "spin_up", "lead", "step", "dwell"):
            _not_negative(rest.get(key, 0.0), key)
        if 0 < rest.get("lead", 0.0) <= rest["radius"]:
            raise ValueError(f"lead is {rest['lead']}, and must be more than the radius, or 0")
    return _TOOLS[kind](**rest)


def parse_machine(name: str, fields: Mapping[str, Any]) -> Machine:
    """Return the machine of a TOML document."""
    axes = {
        axis: Axis(
            **{key: _number(fields["axes"][axis][key], f"{axis}.{key}") for key in Axis.__slots__}
        )
        for axis in "xyzc"
    }
    for axis, limits in axes.items():
        if limits.low >= limits.high or limits.velocity <= 0 or limits.acceleration <= 0:
            raise ValueError(f"axis {axis} must have low < high, and speeds of more than 0")
    stations = tuple(
        Station(
            number=_whole(row["number"], "station number"),
            name=str(row["name"]),
            tool=parse_tool(row["tool"]),
            **{axis: _number(row["datum"][axis], f"datum.{axis}") for axis in "xyzc"},
            output=_whole(row.get("output", -1), "output"),
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
        into_mat=_not_negative(fields["into_mat"], "into_mat"),
        settle=_not_negative(fields["settle"], "settle"),
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
    step = fields.get("groove_pass", 0.0)
    if step and depths["groove_depth"] / _positive(step, "groove_pass") > _MOST_PASSES:
        raise ValueError(f"groove_pass is {step}, and would take more than {_MOST_PASSES} passes")
    spacing = fields.get("bridge_spacing", 0.0)
    if spacing and _positive(spacing, "bridge_spacing") < _LEAST_SPACING:
        raise ValueError(f"bridge_spacing is {spacing}, and must be {_LEAST_SPACING:g} or more")
    cut, gap = fields["perforation"]
    return Board(
        name=name,
        title=str(fields["title"]),
        material=str(fields["material"]),
        caliper=caliper,
        grain=_number(fields["grain"], "grain"),
        **depths,
        end_clearance=_not_negative(fields["end_clearance"], "end_clearance"),
        groove_overcut=_not_negative(fields["groove_overcut"], "groove_overcut"),
        perforation=(_positive(cut, "perforation cut"), _positive(gap, "perforation gap")),
        short_crease=fields["short_crease"],
        deflection=tuple(
            Deflection(
                tool=tool,
                **{axis: _not_negative(given[axis], f"deflection {tool}.{axis}") for axis in "xy"},
            )
            for tool, given in fields.get("deflection", {}).items()
        ),
        **{
            key: _not_negative(fields.get(key, 0.0), key)
            for key in (
                "bridge_width",
                "bridge_spacing",
                "double_crease",
                "groove_pass",
                "groove_curve",
            )
        },
    )


def parse_profile(name: str, fields: Mapping[str, Any]) -> LineRules:
    """Return the profile of a TOML document: a title and a list of ``[[rule]]``.

    With ``extends`` the rules of that profile of the library come first: a layer's name says more
    than the colour that most of these profiles add.
    """
    base = fields.get("extends")
    if base is not None and base not in names("profiles"):
        raise ValueError(f"it extends {base!r}, which is no profile of the library")
    rules = list(profile(base).rules) if base is not None else []
    for number, row in enumerate(fields["rule"], 1):
        unknown = set(row) - {"type", "layer", "colour", "linetype", "entity"}
        if unknown:
            raise ValueError(
                f"rule {number} has {', '.join(sorted(unknown))}, which is no condition"
            )
        if "type" not in row:
            raise ValueError(f"rule {number} has no type")
        colours = _listed(row.get("colour", []), int, f"rule {number}: colour")
        if not all(0 < colour < 256 for colour in colours):
            raise ValueError(f"rule {number}: colours {list(colours)} must lie in 1 … 255")
        rules.append(
            LineRule(
                line_type=LineType.of(row["type"]),
                layer=_listed(row.get("layer", []), str, f"rule {number}: layer"),
                colour=colours,
                linetype=_listed(row.get("linetype", []), str, f"rule {number}: linetype"),
                entity=_listed(row.get("entity", []), str, f"rule {number}: entity"),
            )
        )
    return LineRules(name, str(fields["title"]), tuple(rules))


def _listed(value: Any, kind: type[Made], name: str) -> tuple[Made, ...]:
    """Return one value, or a list of them, as a tuple."""
    values = value if isinstance(value, list) else [value]
    if not all(isinstance(item, kind) and not isinstance(item, bool) for item in values):
        word = {int: "a whole number", str: "text"}[kind]
        raise ValueError(f"{name} is {value!r}, not {word}")
    return tuple(values)
