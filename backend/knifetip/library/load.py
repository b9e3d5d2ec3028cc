"""load: load machines, boards and profiles from the library or from TOML files of the user.

For example, "demo-table" gives a ``Machine``, "e-flute" a ``Board``, "default" a ``LineRules``.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, TypeVar

from knifetip.errors import KnifetipError, LibraryError, ProfileError
from knifetip.fields import InvalidFields, check_fields
from knifetip.languages.registry import find_language
from knifetip.library.toml_text import quote
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine, Station
from knifetip.model.profile import LineRules
from knifetip.model.tool import Cutter, Tool

Record = TypeVar("Record")


def names(shelf: str) -> list[str]:
    """Return the names of all entries of one kind in the library, in alphabetical order.

    Parameters
    ----------
    shelf
        "machines", "boards", "tools" or "profiles".
    """
    return list(_names(shelf))


@cache
def _names(shelf: str) -> tuple[str, ...]:
    folder = resources.files(__package__) / shelf
    entries = (entry.name for entry in folder.iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in entries if name.endswith(".toml")))


def machine(name: str, files: bool = True) -> Machine:
    """Return a machine from the library or from a TOML file.

    Parameters
    ----------
    name
        Name of a machine in the library, or the path of a TOML file.
    files
        Whether ``name`` may be a path.  Must be False for names from the network.

    Raises
    ------
    LibraryError
        The machine does not exist, or its file is invalid.
    """
    return (
        _machine(name)
        if name in names("machines")
        else _load_file("machines", name, files, parse_machine)
    )


def board(name: str, files: bool = True) -> Board:
    """Return a board from the library or from a TOML file.

    Parameters
    ----------
    name
        Name of a board in the library, or the path of a TOML file.
    files
        Whether ``name`` may be a path.  Must be False for names from the network.

    Raises
    ------
    LibraryError
        The board does not exist, or its file is invalid.
    """
    return (
        _board(name) if name in names("boards") else _load_file("boards", name, files, parse_board)
    )


def profile(name: str, files: bool = True) -> LineRules:
    """Return a classification profile from the library or from a TOML file.

    Files of the library are cached.  Files of the user are read each time, since they may change.

    Parameters
    ----------
    name
        Name of a profile in the library, or the path of a TOML file.
    files
        Whether ``name`` may be a path.  Must be False for names from the network.

    Raises
    ------
    LibraryError, ProfileError
        The profile does not exist, or its file is invalid.
    """
    if name in names("profiles"):
        return _profile(name)
    return _load_file("profiles", name, files, parse_profile)


@cache
def _machine(name: str) -> Machine:
    return _parse_file("machines", _library_file("machines", name), name, parse_machine)


@cache
def _board(name: str) -> Board:
    return _parse_file("boards", _library_file("boards", name), name, parse_board)


@cache
def _profile(name: str) -> LineRules:
    return _parse_file("profiles", _library_file("profiles", name), name, parse_profile)


@cache
def conventions() -> tuple[LineRules, ...]:
    """Return for each profile of the library the rules that the default profile lacks.

    Profiles without such rules are omitted.  If a layer, colour and dash pattern in a drawing match
    no rule of the chosen profile, classification tries the returned rules.
    """
    common = set(profile("default", files=False).rules)
    own = []
    for name in _names("profiles"):
        one = profile(name, files=False)
        rest = tuple(rule for rule in one.rules if rule not in common)
        if rest:
            own.append(LineRules(name, one.title, rest))
    return tuple(own)


@cache
def cutters() -> dict[str, Cutter]:
    """Return the router bits of the library by their titles."""
    found = {}
    for name in _names("tools"):
        fields = tomllib.loads(library_text("tools", name))
        tool = parse_tool(name, fields)
        if isinstance(tool, Cutter):
            found[str(fields["title"])] = tool
    return found


def _library_file(shelf: str, name: str) -> Traversable:
    return resources.files(__package__) / shelf / f"{name}.toml"


def _load_file(
    shelf: str, name: str, files: bool, parse: Callable[[str, Mapping[str, Any], str], Record]
) -> Record:
    """Return the machine, board or profile that a TOML file of the user describes.

    ``shelf``: kind of the record: "machines", "boards" or "profiles".
    ``name``: path of the file.
    ``files``: whether files of the user may be read.
    ``parse``: function that makes the machine, board or profile from three arguments: its name, the
    fields in the file, and the path of the file.
    Raises ``LibraryError``: ``files`` is False, or ``name`` is not the path of a readable TOML
    file.
    """
    if files and name.endswith(".toml"):
        return _parse_file(shelf, Path(name), name, parse)
    raise LibraryError(
        "library.unknown", shelf=shelf.removesuffix("s"), name=name[:200], known=names(shelf)
    )


def _parse_file(
    shelf: str,
    file: Path | Traversable,
    name: str,
    parse: Callable[[str, Mapping[str, Any], str], Record],
) -> Record:
    word = shelf.removesuffix("s")
    failure = ProfileError if shelf == "profiles" else LibraryError
    try:
        fields = tomllib.loads(file.read_text("utf-8"))
    except OSError as reason:
        raise LibraryError(
            "library.unknown-file",
            shelf=word,
            name=name[:200],
            reason=reason.strerror,
            known=names(shelf),
        ) from reason
    except (ValueError, RecursionError) as reason:
        raise failure(
            "library.unreadable", shelf=word, name=name[:200], detail=str(reason)
        ) from reason
    return parse(file.name.removesuffix(".toml"), fields, name)


@contextmanager
def _name_document(
    shelf: str, name: str, error: type[KnifetipError] = LibraryError
) -> Iterator[None]:
    """Context manager that replaces an ``InvalidFields`` error by an error that names the document.

    ``shelf``: kind of the document: "machine", "board" or "profile".
    ``name``: name of the document, of which the error contains the first 200 characters.
    ``error``: class of the error that is raised instead, by default ``LibraryError``.
    Raises ``KnifetipError``: an error of class ``error``: the code inside the ``with`` statement
    found a missing, invalid or unknown field.  The attribute ``source`` is the path of the first
    such field.
    """
    try:
        yield
    except InvalidFields as reason:
        raise error(
            "library.invalid",
            shelf=shelf,
            name=name[:200],
            faults=reason.faults,
            source=reason.source,
        ) from None


def find_cutter(machine: Machine, tool: str) -> Station:
    """Return the station of a machine with the name ``tool``, which must hold a cutter or a laser.

    Raises
    ------
    LibraryError
        No station has this name, or its tool is neither a rotating cutter nor a laser.
    """
    cutters = [station for station in machine.stations if station.tool.yields]
    for station in cutters:
        if station.name == tool:
            return station
    if not cutters:
        raise LibraryError("machine.no-cutter", machine=machine.title, cutter=tool[:80])
    cutter_names = [station.name for station in cutters]
    raise LibraryError(
        "machine.no-such-cutter", machine=machine.title, cutter=tool[:80], known=cutter_names
    )


def board_toml(name: str) -> str:
    """Return the TOML text of a board.

    ``name`` is the name of a board in the library, or the path of a TOML file.

    Raises
    ------
    LibraryError
        The board does not exist, or its file is invalid.
    """
    board(name)
    if name in names("boards"):
        return library_text("boards", name)
    return Path(name).read_text("utf-8")


def library_text(shelf: str, name: str) -> str:
    """Return the TOML text of an entry of the library.

    ``shelf`` is the kind of the entry and ``name`` its name, as ``names`` returns it.
    """
    return _library_file(shelf, name).read_text("utf-8")


def parse_machine(name: str, fields: Mapping[str, Any], file: str = "") -> Machine:
    """Return the machine that the fields of a TOML document describe.

    Parameters
    ----------
    name
        Name of the machine.
    fields
        Values by field name, as parsed from the document.
    file
        Name of the file in error messages; if it is empty, ``name`` is used instead.

    Raises
    ------
    LibraryError
        A field is missing, invalid or unknown.
    """
    from knifetip.library.machine_file import MachineFile

    with _name_document("machine", file or name):
        table = check_fields(MachineFile, fields)
        machine = table.record(name)
        settings = find_language(machine.dialect).read_settings(table.controller, machine)
    return replace(machine, controller=settings)


def parse_board(name: str, fields: Mapping[str, Any], file: str = "") -> Board:
    """Return the board that the fields of a TOML document describe.

    Parameters
    ----------
    name
        Name of the board.
    fields
        Values by field name, as parsed from the document.
    file
        Name of the file in error messages; if it is empty, ``name`` is used instead.

    Raises
    ------
    LibraryError
        A field is missing, invalid or unknown.
    """
    from knifetip.library.board_file import BoardFile

    with _name_document("board", file or name):
        return check_fields(BoardFile, fields).record(name)


def parse_tool(name: str, fields: Mapping[str, Any], file: str = "") -> Tool:
    """Return the tool that the fields of a TOML document describe: a title and the table ``tool``.

    Parameters
    ----------
    name
        Name of the tool.
    fields
        Values by field name, as parsed from the document.
    file
        Name of the file in error messages; if it is empty, ``name`` is used instead.

    Raises
    ------
    LibraryError
        A field is missing, invalid or unknown.
    """
    from knifetip.library.machine_file import ToolFile

    with _name_document("tool", file or name):
        return check_fields(ToolFile, fields).record()


def parse_profile(name: str, fields: Mapping[str, Any], file: str = "") -> LineRules:
    """Return the profile that the fields of a TOML document describe: a title and a list of rules.

    A profile may extend a profile of the library.  Then the rules of the library's profile come
    first in the list, then the rules in the document.  If the field ``overrules`` is true,
    the rules in the document come first, as in profiles that are made from a user's corrections.

    Parameters
    ----------
    name
        Name of the profile.
    fields
        Values by field name, as parsed from the document.
    file
        Name of the file in error messages; if it is empty, ``name`` is used instead.

    Raises
    ------
    ProfileError
        A field is missing, invalid or unknown; the attribute ``source`` is the path of the field.
    """
    from knifetip.library.profile_file import ProfileFile

    with _name_document("profile", file or name, ProfileError):
        table = check_fields(ProfileFile, fields)
        if table.extends is not None and table.extends not in (known := names("profiles")):
            value = table.extends[:80]
            fault = Message("field.not-a-profile", path="extends", value=value, known=known)
            raise InvalidFields([fault], ("extends",))
    inherited = profile(table.extends, files=False).rules if table.extends is not None else ()
    own = tuple(rule.record() for rule in table.rule)
    rules = own + inherited if table.overrules else inherited + own
    return LineRules(name, table.title, rules)


def profile_toml(rules: LineRules, extends: str | None = None) -> str:
    """Return the TOML text of a profile; ``parse_profile`` makes the same rules from it.

    Parameters
    ----------
    rules
        The profile, with all its rules.
    extends
        Name of a profile of the library.  Its rules must be the first or the last of ``rules``, and
        only the other rules are written.  With None all rules are written.

    Raises
    ------
    LibraryError
        The profile ``extends`` does not exist.
    ProfileError
        ``rules`` neither begins nor ends with the rules of ``extends``.
    """
    own = rules.rules
    lines = [f"title = {quote(rules.title)}"]
    if extends is not None:
        base = profile(extends, files=False).rules
        rest = len(own) - len(base)
        if rest >= 0 and own[rest:] == base:
            own = own[:rest]
            lines += [f"extends = {quote(extends)}", "overrules = true"]
        elif own[: len(base)] == base:
            own = own[len(base) :]
            lines.append(f"extends = {quote(extends)}")
        else:
            raise ProfileError("profile.not-an-extension", name=rules.name, extends=extends)
    if not own:
        lines.append("rule = []")
    for rule in own:
        lines += ["", "[[rule]]", f"type = {quote(rule.line_type.word)}"]
        colours = [str(colour) for colour in rule.colour]
        colours += [f'"#{colour:06x}"' for colour in rule.true_colour]
        values = {
            "layer": [quote(name) for name in rule.layer],
            "colour": colours,
            "linetype": [quote(name) for name in rule.linetype],
            "entity": [quote(name) for name in rule.entity],
            "block": [quote(name) for name in rule.block],
        }
        lines += [f"{key} = [{', '.join(those)}]" for key, those in values.items() if those]
    return "\n".join(lines) + "\n"
