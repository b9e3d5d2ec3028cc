"""The codes used in the source are those of the catalogue, with the same arguments."""

from __future__ import annotations

import ast
import importlib
import pkgutil
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import knifetip
from knifetip import errors
from knifetip.messages import catalogue
from knifetip.messages.codes import CODES

ROOT = Path(knifetip.__file__).parent
ERRORS = {name for name, kind in vars(errors).items() if isinstance(kind, type)}
#: Arguments of errors that are not arguments of the code.
OTHER = {"source", "at_edges"}


def trees() -> Iterator[tuple[str, ast.Module]]:
    for file in sorted(ROOT.rglob("*.py")):
        if "messages" not in file.relative_to(ROOT).parts:
            yield str(file.relative_to(ROOT)), ast.parse(file.read_text("utf-8"))


def calls() -> Iterator[tuple[str, list[str], set[str] | None]]:
    """Yield location, codes and argument names of each call that makes a message or raises an
    error.

    The argument names are None if the call unpacks a dictionary.
    """
    for name, tree in trees():
        for node in ast.walk(tree):
            if not isinstance(node, ast.Call) or not node.args:
                continue
            called = getattr(node.func, "id", getattr(node.func, "attr", ""))
            if called != "Message" and called not in ERRORS and called != "__init__":
                continue
            codes = constants(node.args[0])
            if not codes:
                continue
            given = {keyword.arg for keyword in node.keywords if keyword.arg} - OTHER
            spread = any(keyword.arg is None for keyword in node.keywords)
            yield f"{name}:{node.lineno}", codes, None if spread else given


def constants(node: ast.expr) -> list[str]:
    match node:
        case ast.Constant(value=str(code)):
            return [code]
        case ast.IfExp():
            return constants(node.body) + constants(node.orelse)
    return []


def test_every_call_has_a_code_of_the_catalogue_and_its_arguments() -> None:
    wrong = [
        (place, code, sorted(given or ()))
        for place, codes, given in calls()
        for code in codes
        if code not in CODES or (given is not None and given != CODES[code].keys())
    ]
    assert wrong == []


def test_each_code_is_in_one_module_of_the_catalogue() -> None:
    areas = [
        importlib.import_module(f"{catalogue.__name__}.{found.name}")
        for found in pkgutil.iter_modules(catalogue.__path__)
    ]
    codes = Counter(code for area in areas for code in area.MESSAGES)
    assert [code for code, count in codes.items() if count > 1] == []
    assert codes.keys() == CODES.keys()


def test_every_code_of_the_catalogue_is_used() -> None:
    used = {
        node.value
        for _, tree in trees()
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    # Clients use it for text without a code.
    assert CODES.keys() - used == {"stored.text"}


def test_calls_are_found() -> None:
    assert len(list(calls())) > 200
