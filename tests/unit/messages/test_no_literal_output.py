"""What commands and the server print are messages of the catalogue, so it can be translated."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest

from tests.unit.messages.test_codes import trees

#: Functions that print.
PRINTERS = {"print_stderr", "print_line", "echo", "secho", "print", "prompt", "confirm"}
#: Words in printed texts that are no language: units, formats, commands and names of options.
WORDS = re.compile(r"knifetip( job confirm)?|--[a-z-]+|=ignored|\b(mm|MB|kB|s|m)\b")


def literals(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Yield line and text of each literal with words in the text that a call prints."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        if getattr(node.func, "id", getattr(node.func, "attr", "")) not in PRINTERS:
            continue
        for argument in node.args[:1]:
            for text in constants(argument):
                if re.search(r"[^\W\d_]{2}", WORDS.sub("", text)):
                    yield node.lineno, text


def constants(node: ast.expr) -> Iterator[str]:
    """Yield the literal parts of an argument, but not what calls, keys and formats contain."""
    match node:
        case ast.Constant(value=str(text)):
            yield text
        case ast.JoinedStr():
            for part in node.values:
                if isinstance(part, ast.Constant):
                    yield from constants(part)
                elif isinstance(part, ast.FormattedValue):
                    yield from constants(part.value)
        case ast.BinOp():
            yield from constants(node.left)
            yield from constants(node.right)
        case ast.IfExp():
            yield from constants(node.body)
            yield from constants(node.orelse)


def test_no_call_prints_a_literal_text() -> None:
    found = {name: lines for name, tree in trees() if (lines := list(literals(tree)))}
    assert found == {}


@pytest.mark.parametrize(
    "way",
    [
        'print_stderr("The drawing was not cleaned.")',
        'print_line(f"  {count} edges")',
        'typer.echo("stored" if row else "missing")',
        'typer.secho(" " * indent + "and more")',
        'print(f"Compiled {done} kernels.", flush=True)',
    ],
)
def test_the_check_finds_literal_texts(way: str) -> None:
    assert list(literals(ast.parse(way)))


@pytest.mark.parametrize(
    "way",
    [
        'print_line(in_words(Message("output.read", file=name)))',
        'print_line(f"{row.name:20} {row.role:9}")',
        'print_stderr(f"  knifetip job confirm {job} --checked {ids}")',
        'print_stderr(f"? {question}", "yellow")',
    ],
)
def test_the_check_accepts_messages_data_and_commands(way: str) -> None:
    assert list(literals(ast.parse(way))) == []
