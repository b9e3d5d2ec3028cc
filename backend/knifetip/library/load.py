"""load: machines, boards and profiles by name, or from a TOML file of the user's own.

"demo-table" -> Machine        "e-flute" -> Board        "default" -> LineRules
"""

from __future__ import annotations

import json
import math
import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, TypeVar

from knifetip.errors import LibraryError, ProfileError
from knifetip.languages.registry import find_language
from knifetip.languages.registry import names as languages
from knifetip.model.board import Board, Deflection
from knifetip.model.dieline import LineType
from knifetip.model.machine import Axis, Machine, Station
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.tool import KINDS, Tool

Made = TypeVar("Made")

_TOOLS: dict[str, type[Tool]] = {kind.name: kind.tool for kind in KINDS}

#: How a sheet gets onto a table: laid on by a person, or by the machine itself.
FEEDS = ("manual", "automatic")

#: More passes along one groove than this, or bridges nearer than this (mm), are a slip of the pen.
_MOST_PASSES = 50
_LEAST_SPACING = 10.0


def names(shelf: str) -> list[str]:
    """Return the names on a shelf: ``machines``, ``boards`` or ``profiles``."""
    return list(_names(shelf))


@cache
def _names(shelf: str) -> tuple[str, ...]:
    folder = resources.files(__package__) / shelf
    found = (entry.name for entry in folder.iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in found if name.endswith(".toml")))


def machine(name: str, files: bool = True) -> Machine:
    """Return a machine of the library, or of a TOML file; see ``profile`` for ``files``.

    Raises
    ------
    LibraryError
        There is no such machine, or its file is wrong.
    """
    return (
        _machine(name)
        if name in names("machines")
        else _own("machines", name, files, parse_machine)
    )


def board(name: str, files: bool = True) -> Board:
    """Return a board of the library, or of a TOML file; see ``profile`` for ``files``.

    Raises
    ------
    LibraryError
        There is no such board, or its file is wrong.
    """
    return _board(name) if name in names("boards") else _own("boards", name, files, parse_board)


def profile(name: str, files: bool = True) -> LineRules:
    """Return a classification profile of the library, or of a TOML file.

    What is shipped is read once.  A file of the user's own is read each time: it may be edited.

    Parameters
    ----------
    files
        Whether ``name`` may be the path of a TOML file; never say so for a name that comes from
        another machine.

    Raises
    ------
    LibraryError, ProfileError
        There is no such profile, or its file is wrong.
    """
    if name in names("profiles"):
        return _profile(name)
    return _own("profiles", name, files, parse_profile)


@cache
def _machine(name: str) -> Machine:
    return _made("machines", _shipped("machines", name), name, parse_machine)


@cache
def _board(name: str) -> Board:
    return _made("boards", _shipped("boards", name), name, parse_board)


@cache
def _profile(name: str) -> LineRules:
    return _made("profiles", _shipped("profiles", name), name, parse_profile)


@cache
def conventions() -> tuple[LineRules, ...]:
    """Return what makes each profile of the library differ from the default: its house's colours.

    Classification tries them where the chosen profile says nothing.
    """
    common = set(profile("default", files=False).rules)
    own = []
    for name in _names("profiles"):
        one = profile(name, files=False)
        rest = tuple(rule for rule in one.rules if rule not in common)
        if rest:
            own.append(LineRules(name, one.title, rest))
    return tuple(own)


def _shipped(shelf: str, name: str) -> Traversable:
    return resources.files(__package__) / shelf / f"{name}.toml"


def _own(
    shelf: str, name: str, files: bool, parse: Callable[[str, Mapping[str, Any]], Made]
) -> Made:
    """Return what a file of the user's own says."""
    if files and name.endswith(".toml"):
        return _made(shelf, Path(name), name, parse)
    raise LibraryError(
        "library.unknown", shelf=shelf.removesuffix("s"), name=name[:200], known=names(shelf)
    )


def _made(
    shelf: str,
    file: Path | Traversable,
    name: str,
    parse: Callable[[str, Mapping[str, Any]], Made],
) -> Made:
    word = shelf.removesuffix("s")
    failure = ProfileError if shelf == "profiles" else LibraryError
    try:
        return parse(file.name.removesuffix(".toml"), tomllib.loads(file.read_text("utf-8")))
    except OSError as reason:
        raise LibraryError(
            "library.unknown-file",
            shelf=word,
            name=name,
            reason=reason.strerror,
            known=names(shelf),
        ) from reason
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError) as reason:
        detail = f"{reason.args[0]!r} is missing" if isinstance(reason, KeyError) else str(reason)
        raise failure("library.unreadable", shelf=word, name=name, detail=detail) from reason


def cutter_of(machine: Machine, tool: str) -> Station:
    """Return the station of a machine's cutter, by its name.

    Raises
    ------
    LibraryError
        The machine has no such station, or it holds another kind of tool.
    """
    cutters = [station for station in machine.stations if station.tool.yields]
    for station in cutters:
        if station.name == tool:
            return station
    if not cutters:
        raise LibraryError("machine.no-cutter", machine=machine.title, cutter=tool[:80])
    known = [station.name for station in cutters]
    raise LibraryError(
        "machine.no-such-cutter", machine=machine.title, cutter=tool[:80], known=known
    )


def text_of_board(name: str) -> str:
    """Return the TOML of a board of the library, or of a file.

    Raises
    ------
    LibraryError
        There is no such board, or its file is wrong.
    """
    board(name)
    if name in names("boards"):
        return (resources.files(__package__) / "boards" / f"{name}.toml").read_text("utf-8")
    return Path(name).read_text("utf-8")


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
    machine = Machine(
        name=name,
        title=str(fields["title"]),
        width=_positive(fields["width"], "width"),
        height=_positive(fields["height"], "height"),
        **axes,
        stations=stations,
        dialect=_dialect(fields["dialect"]),
        origin=(
            _number(fields["origin"][0], "origin x"),
            _number(fields["origin"][1], "origin y"),
        ),
        travel_z=_positive(fields["travel_z"], "travel_z"),
        clearance=_positive(fields["clearance"], "clearance"),
        into_mat=_not_negative(fields["into_mat"], "into_mat"),
        settle=_not_negative(fields["settle"], "settle"),
        feed=_feed(fields.get("feed", "manual")),
    )
    language = find_language(machine.dialect)
    settings = language.read_settings(fields.get("controller", {}), machine)
    return replace(machine, controller=settings)


def _dialect(value: Any) -> str:
    try:
        return find_language(str(value)).name
    except LibraryError:
        known = ", ".join(languages())
        raise ValueError(f"dialect is {value!r}: it is one of {known}") from None


def _feed(value: Any) -> str:
    if value not in FEEDS:
        raise ValueError(f"feed is {value!r}: it is {' or '.join(FEEDS)}")
    return str(value)


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
    than the colour that most of these profiles add.  With ``overrules = true`` they come last:
    so do profiles that somebody's corrections made.

    A colour is an index, ``5``, or a true colour, ``"#00aeef"``.
    """
    unknown = set(fields) - {"title", "extends", "overrules", "rule"}
    if unknown:
        raise ValueError(f"{', '.join(sorted(map(repr, unknown)))} means nothing in a profile")
    base = fields.get("extends")
    if base is not None and base not in names("profiles"):
        raise ValueError(f"it extends {base!r}, which is no profile of the library")
    inherited = profile(base, files=False).rules if base is not None else ()
    own = tuple(_rule(number, row) for number, row in enumerate(fields["rule"], 1))
    overrules = fields.get("overrules", False)
    if not isinstance(overrules, bool):
        # As of all that a profile may say wrong; a TypeError would be ours.
        raise ValueError(f"overrules is {overrules!r}: it is true or false")  # noqa: TRY004
    return LineRules(name, str(fields["title"]), own + inherited if overrules else inherited + own)


_CONDITIONS = ("layer", "colour", "linetype", "entity", "block")


def _rule(number: int, row: Mapping[str, Any]) -> LineRule:
    unknown = set(row) - {"type", *_CONDITIONS}
    if unknown:
        raise ValueError(f"rule {number} has {', '.join(sorted(unknown))}, which is no condition")
    if "type" not in row:
        raise ValueError(f"rule {number} has no type")
    given = row.get("colour", [])
    listed = given if isinstance(given, list) else [given]
    true_colours = tuple(_true_colour(number, it) for it in listed if isinstance(it, str))
    numbers = [it for it in listed if not isinstance(it, str)] if true_colours else given
    indices = _listed(numbers, int, f"rule {number}: colour")
    if not all(0 < colour < 256 for colour in indices):
        raise ValueError(f"rule {number}: colours {list(indices)} must lie in 1 … 255")
    texts = {
        key: _listed(row.get(key, []), str, f"rule {number}: {key}")
        for key in _CONDITIONS
        if key != "colour"
    }
    try:
        kind = LineType.of(str(row["type"]))
    except ValueError as reason:
        raise ValueError(f"rule {number}: type {reason}") from reason
    return LineRule(
        line_type=kind,
        colour=indices,
        true_colour=true_colours,
        **texts,
    )


def _true_colour(number: int, text: str) -> int:
    if not re.fullmatch("#[0-9a-fA-F]{6}", text):
        raise ValueError(f'rule {number}: colour is {text!r}, not a whole number or "#rrggbb"')
    return int(text[1:], 16)


def _listed(value: Any, kind: type[Made], name: str) -> tuple[Made, ...]:
    """Return one value, or a list of them, as a tuple."""
    values = value if isinstance(value, list) else [value]
    if not all(isinstance(item, kind) and not isinstance(item, bool) for item in values):
        word = {int: "a whole number", str: "text"}[kind]
        raise ValueError(f"{name} is {value!r}, not {word}")
    return tuple(values)


def profile_toml(rules: LineRules, extends: str | None = None) -> str:
    """Return a profile as TOML, which ``parse_profile`` reads back as the same rules.

    Parameters
    ----------
    extends
        A profile of the library that these rules begin or end with, so that only the others are
        written; None writes all of them.

    Raises
    ------
    LibraryError
        There is no such profile on the shelf.
    ProfileError
        The rules neither begin nor end with those that they are said to extend.
    """
    own = rules.rules
    lines = [f"title = {_quoted(rules.title)}"]
    if extends is not None:
        base = profile(extends, files=False).rules
        rest = len(own) - len(base)
        if rest >= 0 and own[rest:] == base:
            own = own[:rest]
            lines += [f"extends = {_quoted(extends)}", "overrules = true"]
        elif own[: len(base)] == base:
            own = own[len(base) :]
            lines.append(f"extends = {_quoted(extends)}")
        else:
            raise ProfileError("profile.not-an-extension", name=rules.name, extends=extends)
    if not own:
        lines.append("rule = []")
    for rule in own:
        lines += ["", "[[rule]]", f"type = {_quoted(rule.line_type.word)}"]
        colours = [str(colour) for colour in rule.colour]
        colours += [f'"#{colour:06x}"' for colour in rule.true_colour]
        values = {
            "layer": [_quoted(name) for name in rule.layer],
            "colour": colours,
            "linetype": [_quoted(name) for name in rule.linetype],
            "entity": [_quoted(name) for name in rule.entity],
            "block": [_quoted(name) for name in rule.block],
        }
        lines += [f"{key} = [{', '.join(those)}]" for key, those in values.items() if those]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    # Half a surrogate pair cannot be written as UTF-8: ? stands for any one sign in a pattern.
    clean = text.encode("utf-8", "replace").decode("utf-8")
    return json.dumps(clean, ensure_ascii=False).replace("\x7f", "\\u007f")
