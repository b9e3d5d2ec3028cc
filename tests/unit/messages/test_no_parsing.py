"""No code of the package parses a sentence to decide something."""

from __future__ import annotations

import ast
from pathlib import Path

import knifetip

ROOT = Path(knifetip.__file__).parent
#: Names of fields, variables and keys that contain sentences.
SENTENCES = {"detail", "evidence", "hint", "message", "reason", "reasons", "sentence", "why"}
#: Methods of str, and functions of re, that split, search or compare a text.
APART = {
    "count",
    "endswith",
    "find",
    "findall",
    "finditer",
    "fullmatch",
    "index",
    "match",
    "partition",
    "removeprefix",
    "removesuffix",
    "replace",
    "rpartition",
    "rsplit",
    "search",
    "split",
    "startswith",
    "sub",
}


def holds_sentence(node: ast.AST) -> bool:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name) | ast.Constant(value=str(name)):
            return name in SENTENCES
        case ast.Subscript(value=value, slice=key):
            return holds_sentence(key) or holds_sentence(value)
        case ast.Call(func=ast.Attribute(value=value, attr=method)):
            # reason.text.lower(), str methods in a row, row.get("reason")
            return holds_sentence(value) or (
                method == "get" and any(holds_sentence(one) for one in node.args[:1])
            )
        case ast.Call(func=ast.Name(id="str"), args=[value]):
            return holds_sentence(value)
    return False


def parsing(tree: ast.AST) -> list[int]:
    """Return the lines on which a sentence is split, searched or compared with a text."""
    lines = []
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(value=value, attr=method), args=args):
                if method in APART and (holds_sentence(value) or any(map(holds_sentence, args))):
                    lines.append(node.lineno)
            case ast.Compare(left=left, ops=[ast.In() | ast.NotIn()], comparators=[right]):
                if isinstance(left, ast.Constant | ast.JoinedStr) and holds_sentence(right):
                    lines.append(node.lineno)
            case ast.Compare(left=left, ops=[ast.Eq() | ast.NotEq()], comparators=[right]):
                for one, other in ((left, right), (right, left)):
                    if isinstance(other, ast.Constant) and other.value and holds_sentence(one):
                        lines.append(node.lineno)
    return lines


def test_no_sentence_is_parsed() -> None:
    found = {
        file.relative_to(ROOT).as_posix(): lines
        for file in sorted(ROOT.rglob("*.py"))
        if (lines := parsing(ast.parse(file.read_text("utf-8"))))
    }
    assert found == {}


def test_the_check_finds_each_way_of_parsing() -> None:
    ways = (
        'drawing.evidence.startswith("x")',
        '"x" in import_report.reason[row]',
        're.sub("x", "", reason)',
        'PATTERN.match(row["reason"])',
        'str(error.message).partition(":")',
        'job.hint == "x"',
        'row.get("why").split()',
    )
    assert [len(parsing(ast.parse(way))) for way in ways] == [1] * len(ways)
