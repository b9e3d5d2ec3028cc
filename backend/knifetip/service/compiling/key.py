"""Hash of everything on which the result of a compile depends.

Two compiles with one key have the same program and verdict, so the second is not needed.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Final

import knifetip
from knifetip.fields import Table
from knifetip.library.definition import Definition

#: Files of the package that determine results: code, machines, boards and profiles.
_SOURCES: Final = (".py", ".toml")


def compile_key(arguments: tuple[object, ...]) -> str:
    """Return the key of a compile: a SHA-256 hash in hexadecimal digits.

    It depends on each field of each argument, on the text of the machine and the board, and on the
    files of knifetip.

    Parameters
    ----------
    arguments
        All arguments of ``tasks.compile`` except the first.

    Raises
    ------
    TypeError
        An argument contains an object of an unknown type.
    """
    return digest_of((_code_version(), arguments))


def digest_of(value: object) -> str:
    """Return a SHA-256 hash of a value in hexadecimal digits; it depends on each of its fields.

    Raises
    ------
    TypeError
        The value contains an object of an unknown type.
    """
    digest = hashlib.sha256()
    for part in _parts(value):
        # The length separates neighbouring parts.
        digest.update(len(part).to_bytes(8, "big") + part)
    return digest.hexdigest()


def _parts(value: object) -> Iterator[bytes]:
    """Yield a value as bytes, each after the name of its type."""
    yield type(value).__name__.encode()
    match value:
        case None:
            pass
        case bytes():
            yield value
        case Enum():
            yield value.name.encode()
        case bool() | int() | float() | str():
            yield repr(value).encode()
        case tuple() | list():
            yield str(len(value)).encode()
            for item in value:
                yield from _parts(item)
        case _ if is_dataclass(value):
            for field in fields(value):
                yield field.name.encode()
                yield from _parts(getattr(value, field.name))
            if isinstance(value, Definition):
                yield value.toml.encode()
        case Table():
            for name in type(value).model_fields:
                yield name.encode()
                yield from _parts(getattr(value, name))
        case _:
            raise TypeError(f"no hash of a {type(value).__name__}")


@cache
def _code_version() -> str:
    """Return a hash of knifetip's files, which also changes between two builds of one version."""
    digest = hashlib.sha256()
    root = Path(knifetip.__file__).parent
    for path in sorted(path for path in root.rglob("*") if path.suffix in _SOURCES):
        content = path.read_bytes()
        name = path.relative_to(root).as_posix().encode()
        for part in (name, content):
            digest.update(len(part).to_bytes(8, "big") + part)
    return digest.hexdigest()
