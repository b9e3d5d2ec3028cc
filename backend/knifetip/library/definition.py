"""definition: machines, boards and tools that users have made, as TOML text with a version.

A definition names a machine, a board or a tool, and contains its TOML text if a user has made it.
The text comes from users and is not trusted: its size is limited, it cannot refer to files, and it
is either valid or refused.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import Any, Final

from knifetip.errors import LibraryError
from knifetip.harmless import harmless
from knifetip.library import load
from knifetip.library.toml_text import read_toml, write_toml
from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.machine import Machine
from knifetip.model.tool import Tool

MAX_BYTES: Final = 256 << 10  #: largest size of the text of a definition
MAX_TEXT: Final = 200  #: most characters of a title or another text in a definition

#: Names contain no dot, since names that end in .toml refer to files on the command line.
NAME_PATTERN: Final = "[a-z0-9][a-z0-9_-]{0,63}"


class Shelf(StrEnum):
    """Kinds of definitions, by the names of their folders in the library."""

    MACHINES = "machines"
    BOARDS = "boards"
    TOOLS = "tools"

    @property
    def word(self) -> str:
        """The name of one entry, such as "machine"."""
        return self.value.removesuffix("s")


@dataclass(frozen=True, slots=True)
class Definition:
    """A version of a machine, a board or a tool.

    The version of entries of knifetip's library is 0, and their text is "".
    """

    shelf: Shelf
    name: str
    version: int = 0
    text: str = ""  #: TOML; "" for an entry of knifetip's library

    @property
    def toml(self) -> str:
        """The TOML text, also of an entry of knifetip's library."""
        return self.text or load.library_text(self.shelf, self.name)


def is_name(name: str) -> bool:
    """Return whether a text may be the name of a definition or a profile that a user makes.

    Such a name has at most 64 characters: lower-case letters, digits, hyphens and underscores.
    """
    return re.fullmatch(NAME_PATTERN, name) is not None


def machine_of(definition: Definition) -> Machine:
    """Return the machine that a definition describes.

    Raises
    ------
    LibraryError
        The definition is invalid, for example because an older version of knifetip stored it.
    """
    if not definition.text:
        return load.machine(definition.name, files=False)
    return _machine(definition)


def board_of(definition: Definition) -> Board:
    """Return the board that a definition describes.

    Raises
    ------
    LibraryError
        The definition is invalid, for example because an older version of knifetip stored it.
    """
    if not definition.text:
        return load.board(definition.name, files=False)
    return _board(definition)


@lru_cache(maxsize=256)
def _machine(definition: Definition) -> Machine:
    fields = parse_toml(definition.shelf, definition.name, definition.text)
    return replace(load.parse_machine(definition.name, fields), version=definition.version)


@lru_cache(maxsize=256)
def _board(definition: Definition) -> Board:
    fields = parse_toml(definition.shelf, definition.name, definition.text)
    return replace(load.parse_board(definition.name, fields), version=definition.version)


_PARSERS: Final[Mapping[Shelf, Callable[[str, Mapping[str, Any]], Machine | Board | Tool]]] = {
    Shelf.MACHINES: load.parse_machine,
    Shelf.BOARDS: load.parse_board,
    Shelf.TOOLS: load.parse_tool,
}


@lru_cache(maxsize=1024)
def check_definition(shelf: Shelf, name: str, text: str) -> str:
    """Return the title of a machine, board or tool after checking its TOML text.

    Raises
    ------
    LibraryError
        The text is not TOML, or a field is missing, invalid or unknown; the message contains each
        fault with the path of its field.
    """
    fields = parse_toml(shelf, name, text)
    _PARSERS[shelf](name, fields)
    return str(fields["title"])


def parse_toml(shelf: Shelf, name: str, text: str) -> dict[str, Any]:
    """Return the fields in the TOML text of a definition, which are not checked.

    Raises
    ------
    LibraryError
        The text is not TOML, or its tables are nested too deeply.
    """
    try:
        return read_toml(text)
    except ValueError as reason:
        raise LibraryError(
            "library.not-toml", shelf=shelf.word, name=name[:80], reason=str(reason)[:200]
        ) from reason
    except RecursionError as reason:
        raise LibraryError("library.nested-too-deep", shelf=shelf.word, name=name[:80]) from reason


def check_texts(shelf: str, name: str, fields: Mapping[str, Any]) -> None:
    """Check that the names and texts in a definition do nothing where they are shown.

    Definitions that were stored before are not checked, so that their jobs can be made.

    Parameters
    ----------
    shelf
        Word for the kind of the definition.
    name
        Name of the definition.
    fields
        Its fields.

    Raises
    ------
    LibraryError
        A text or the name of a field has a character that acts on a terminal, a log or the
        direction of text, or is too long.
    """
    for path, text in _texts(fields, ()):
        field, shown = harmless(".".join(path))[:80], harmless(text)
        given = {"shelf": shelf, "name": name[:80], "field": field, "text": shown[:80]}
        if shown != text:
            raise LibraryError(Message("library.acting-text", **given), source=(field,))
        if len(text) > MAX_TEXT:
            raise LibraryError(
                Message("library.long-text", limit=MAX_TEXT, **given), source=(field,)
            )


def _texts(value: object, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield the texts and the names of fields in a value, with their paths."""
    if isinstance(value, str):
        yield path, value
    elif isinstance(value, Mapping):
        for key, one in value.items():
            yield path, key
            yield from _texts(one, (*path, key))
    elif isinstance(value, list):
        for row, one in enumerate(value):
            yield from _texts(one, (*path, str(row)))


def decode(shelf: Shelf, name: str, content: bytes) -> str:
    """Return the text of a definition from its bytes in UTF-8.

    Raises
    ------
    LibraryError
        The content is too large, or is not UTF-8.
    """
    if len(content) > MAX_BYTES:
        raise LibraryError(
            "library.too-long",
            shelf=shelf.word,
            name=name[:80],
            size=len(content) >> 10,
            limit=MAX_BYTES >> 10,
        )
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as reason:
        raise LibraryError(
            "library.not-utf8", shelf=shelf.word, name=name[:80], byte=reason.start
        ) from reason


def toml_from_json(shelf: Shelf, name: str, text: str) -> str:
    """Return the TOML text of a definition whose fields are given as JSON text.

    Raises
    ------
    LibraryError
        The text is not JSON, is not an object, is nested too deeply, or contains a value that TOML
        does not have.
    """
    shown = name[:80]
    try:
        fields = json.loads(text)
        if not isinstance(fields, dict):
            raise LibraryError("library.not-an-object", shelf=shelf.word, name=shown)
        return write_toml(fields)
    except TypeError as reason:
        raise LibraryError("library.null-in-list", shelf=shelf.word, name=shown) from reason
    except json.JSONDecodeError as reason:
        text = f"the fault is in line {reason.lineno}, column {reason.colno}"
        raise LibraryError(
            "library.not-json", shelf=shelf.word, name=shown, reason=text
        ) from reason
    except ValueError as reason:
        text = "a number in it is too long"
        raise LibraryError(
            "library.not-json", shelf=shelf.word, name=shown, reason=text
        ) from reason
    except RecursionError as reason:
        raise LibraryError("library.nested-too-deep", shelf=shelf.word, name=shown) from reason
