"""Arguments of messages are data: only the catalogue contains English, so it can be translated."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from tests.unit.messages.test_codes import ERRORS, constants, trees

#: Modules with English in arguments, and the reason.
JUSTIFIED = {
    # The operating system reports no reason if a connection times out.
    "gateway/transport.py",
}


def prose(node: ast.AST) -> Iterator[str]:
    """Yield the literal texts with a space in an argument of a message."""
    match node:
        case ast.Call(func=ast.Name(id="Message")):
            return  # a message in the arguments is checked separately
        case ast.Constant(value=str(text)) if " " in text.strip():
            yield text
    for part in ast.iter_child_nodes(node):
        yield from prose(part)


def literals(tree: ast.AST) -> list[tuple[int, str]]:
    """Return line and text of each English literal in an argument of a message or an error."""
    return [
        (node.lineno, text)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and node.args
        if getattr(node.func, "id", getattr(node.func, "attr", "")) in ERRORS | {"Message"}
        if constants(node.args[0])
        for keyword in node.keywords
        for text in prose(keyword.value)
    ]


def test_no_argument_of_a_message_is_an_english_literal() -> None:
    found = {name: lines for name, tree in trees() if (lines := literals(tree))}
    assert found.keys() <= JUSTIFIED, found


def test_the_check_finds_literals_and_parts_of_formatted_texts() -> None:
    ways = (
        'Message("a.b", reason="it is truncated")',
        'PlanError("a.b", reason=f"is {value}, not a number")',
        'Message("a.b", reason=reason or "timed out")',
    )
    assert [len(literals(ast.parse(way))) for way in ways] == [1, 1, 1]
    nested = 'Message("a.b", reason=Message("c.d", name="X"))'
    assert literals(ast.parse(nested)) == []
