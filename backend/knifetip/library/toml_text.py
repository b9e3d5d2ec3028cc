"""toml_text: read TOML text that is not trusted, and write fields as TOML text."""

from __future__ import annotations

import datetime
import json
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Final

from knifetip.errors import LibraryError

_BARE_KEY: Final = re.compile(r"[A-Za-z0-9_-]+")
_MAX_DEPTH: Final = 32  # tables and lists in each other; a machine has 6
#: Parts of dotted keys, and the dots between them.
_KEY_TOKEN: Final = re.compile(
    r"""(?P<part>[\w-]++|"(?:[^"\\\n]|\\.)*+"?|'[^'\n]*+'?)|(?P<dot>\.)|[ \t]++|(?P<other>.)""",
    re.DOTALL,
)
_INTEGER_LIMIT: Final = 1 << 63  # a TOML integer has 64 bits


def read_toml(text: str) -> dict[str, Any]:
    """Return the fields in a TOML text.

    Raises
    ------
    ValueError
        The text is not TOML.
    LibraryError
        The text contains an integer of more than 64 bits.
    RecursionError
        Tables and lists are nested too deeply.
    """
    if _is_key_deep(text):  # tomllib would take memory for the square of the number of its parts
        raise RecursionError
    fields = tomllib.loads(text)
    level: list[Any] = [fields]
    for _ in range(_MAX_DEPTH):
        level = [inner for value in level for inner in _nested_values(value)]
        if any(isinstance(one, int) and abs(one) >= _INTEGER_LIMIT for one in level):
            raise LibraryError("library.large-integer")
        if not level:
            return fields
    raise RecursionError


def _is_key_deep(text: str) -> bool:
    """Return whether a dotted key has more parts than tables may be nested."""
    parts, dotted = 0, False
    for token in _KEY_TOKEN.finditer(text):
        if token["part"]:
            parts, dotted = parts + 1 if dotted else 1, False
            if parts > _MAX_DEPTH:
                return True
        elif token["dot"]:
            dotted = True
        elif token["other"]:
            parts, dotted = 0, False
    return False


def _nested_values(value: Any) -> Iterable[Any]:
    """Return the values in a table or a list; none for another value."""
    if isinstance(value, dict):
        return value.values()
    return value if isinstance(value, list) else ()


def quote(text: str) -> str:
    """Return a text as a TOML string in quotation marks.

    A lone surrogate, which has no UTF-8, is replaced by a question mark.
    """
    clean = text.encode("utf-8", "replace").decode("utf-8")
    return json.dumps(clean, ensure_ascii=False).replace("\x7f", "\\u007f")


def key_text(key: str) -> str:
    """Return a key as TOML text: without quotation marks if TOML permits that."""
    return key if _BARE_KEY.fullmatch(key) else quote(key)


def write_toml(fields: Mapping[str, Any]) -> str:
    """Return the TOML text of a document; ``tomllib.loads`` returns the same fields.

    Parameters
    ----------
    fields
        Values by name: texts, numbers, booleans, lists and tables.  Entries that are None are
        omitted, because TOML has no such value.

    Raises
    ------
    TypeError
        A value has a type that TOML does not have, for example None in a list.
    """
    return "\n".join(_lines(fields, ())).strip("\n") + "\n"


def _lines(table: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[str]:
    """Yield the lines of a table: first its values, then its tables.

    ``path``: keys that lead to the table, as TOML text.
    """
    present = {key: value for key, value in table.items() if value is not None}
    for key, value in present.items():
        if not (isinstance(value, Mapping) or _is_table_list(value)):
            yield f"{key_text(key)} = {_value(value)}"
    for key, value in present.items():
        name = (*path, key_text(key))
        if isinstance(value, Mapping):
            yield from ("", f"[{'.'.join(name)}]", *_lines(value, name))
        elif _is_table_list(value):
            for entry in value:
                yield from ("", f"[[{'.'.join(name)}]]", *_lines(entry, name))


def _is_table_list(value: Any) -> bool:
    return (
        isinstance(value, list) and bool(value) and all(isinstance(one, Mapping) for one in value)
    )


def _value(value: Any) -> str:
    """Return a value as TOML text on one line.

    Raises ``TypeError``: TOML has no such type.
    """
    match value:
        case bool():
            return "true" if value else "false"
        case str():
            return quote(value)
        case int() | float():
            return repr(value)
        case datetime.date() | datetime.time():
            return value.isoformat()
        case list():
            return f"[{', '.join(map(_value, value))}]"
        case Mapping():
            present = {key: one for key, one in value.items() if one is not None}
            pairs = (f"{key_text(key)} = {_value(one)}" for key, one in present.items())
            return f"{{ {', '.join(pairs)} }}" if present else "{}"
    raise TypeError(type(value).__name__)
