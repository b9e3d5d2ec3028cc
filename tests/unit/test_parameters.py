"""No function has more parameters than a reader can keep apart."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import knifetip

ROOT = Path(knifetip.__file__).parent
#: Arrays and numbers that belong together are fields of one record.
MOST = 8


def long_lists(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Yield name and number of parameters of each function that has too many."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            found = node.args
            count = len(found.posonlyargs) + len(found.args) + len(found.kwonlyargs)
            if count > MOST:
                yield node.name, count


def test_no_function_has_more_than_eight_parameters() -> None:
    found = {
        str(file.relative_to(ROOT)): functions
        for file in sorted(ROOT.rglob("*.py"))
        if (functions := list(long_lists(ast.parse(file.read_text("utf-8")))))
    }
    assert found == {}


@pytest.mark.parametrize(
    "parameters", ["a, b, c, d, e, f, g, h, i", "a, b, c, d, /, e, f, g, *, h, i=0"]
)
def test_nine_parameters_are_too_many(parameters: str) -> None:
    source = f"class Some:\n    async def method({parameters}): ...\n"
    assert list(long_lists(ast.parse(source))) == [("method", 9)]
    assert list(long_lists(ast.parse(source.replace("a, ", "", 1)))) == []
