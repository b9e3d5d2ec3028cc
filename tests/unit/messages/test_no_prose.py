"""Arguments of messages are data: only the catalogue contains English, so it can be translated.

Errors of Python, such as ``ValueError``, have sentences only where a mistake of a programmer is the
reason, or where every caller reports a message of the catalogue instead.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable, Iterator

import pytest

from tests.unit.messages.test_codes import ERRORS, trees

#: Classes and functions that make messages or errors with messages: the arguments are data.
MAKERS = ERRORS | {"Message", "field_error", "failure"}
BUILTINS = {
    name
    for name, kind in vars(builtins).items()
    if isinstance(kind, type) and issubclass(kind, BaseException)
}
#: Modules with English in arguments of messages, and the reason.
JUSTIFIED = {
    "gateway/transports/tcp.py": "the system has no reason for a connection that times out",
    "sequencing/travel.py": "symbols of units are the same in all languages",
}
#: Modules whose errors of Python have sentences, and the reason why users do not see them.
NOT_FOR_USERS = {
    "service/http/routing.py": "a route declares no scope, so the server does not start",
    "__init__.py": "the package has no such attribute",
    "classification/classify.py": "a program passes overrides of another drawing",
    "classification/rule_proposals.py": "a program passes overrides of another drawing",
    "simulators/grbl/table.py": "a program simulates a table at no speed",
    "contract/station_report.py": "the gateway discards an answer that it cannot read",
    "geometry/columns.py": "a program passes arrays of other shapes",
    "geometry/path.py": "a program passes arrays of other shapes",
    "service/compiling/key.py": "a compile depends on an object without a defined hash",
    "service/database/large_value.py": "a program reads a value that it has not loaded",
    "service/compiling/durable_queue.py": "a program starts two queues in one process",
    "kernels/declare.py": "the declaration of a kernel is wrong",
    "model/dieline.py": "each caller reports its own message for a name that is no line type",
    "model/drawing.py": "a program passes arrays of other shapes",
    "pdf/content.py": "cannot happen",
    "presentation/columns.py": "a program passes other bytes than those that the server sent",
    "svg/colours.py": "the reader of styles uses the inherited colour instead",
}


def prose(node: ast.AST) -> Iterator[str]:
    """Yield the literal texts with letters and a space in an argument of a message."""
    match node:
        case ast.Call(func=ast.Name(id="Message")):
            return  # a message in the arguments is checked separately
        case ast.Constant(value=str(text)) if " " in text and any(map(str.isalpha, text)):
            yield text
    for part in ast.iter_child_nodes(node):
        yield from prose(part)


def literals(tree: ast.AST, makers: Iterable[str] = MAKERS) -> list[tuple[int, str]]:
    """Return line and text of each English literal in an argument of a message or an error."""
    return [
        (node.lineno, text)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        if getattr(node.func, "id", getattr(node.func, "attr", "")) in makers
        for argument in (*node.args, *(keyword.value for keyword in node.keywords))
        for text in prose(argument)
    ]


def test_no_argument_of_a_message_is_an_english_literal() -> None:
    found = {name: lines for name, tree in trees() if (lines := literals(tree))}
    assert found.keys() == JUSTIFIED.keys(), found


def test_errors_of_python_have_sentences_only_if_users_do_not_see_them() -> None:
    found = {name: lines for name, tree in trees() if (lines := literals(tree, BUILTINS))}
    assert found.keys() == NOT_FOR_USERS.keys(), found


@pytest.mark.parametrize(
    "way",
    [
        'Message("a.b", reason="it is truncated")',
        'PlanError("a.b", reason=f"is {value}, not a number")',
        'Message("a.b", reason=reason or "timed out")',
        'Message("a.b", names=" or ".join(names))',
        'Message(code, reason="it is truncated")',
        'Message("it is truncated")',
        'errors.PlanError(code, reason="it is truncated")',
        'field_error("a.b", fault="it is truncated")',
    ],
)
def test_the_check_finds_literals_and_parts_of_formatted_texts(way: str) -> None:
    assert literals(ast.parse(way))


def test_the_check_finds_sentences_of_python_errors() -> None:
    assert literals(ast.parse('raise ValueError(f"{n} is too large")'), BUILTINS)
    assert literals(ast.parse("raise KeyError(name)"), BUILTINS) == []


def test_the_check_accepts_a_message_in_the_arguments() -> None:
    nested = 'Message("a.b", reason=Message("c.d", name="X"))'
    assert literals(ast.parse(nested)) == []
