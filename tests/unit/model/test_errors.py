"""The tree of error classes in the docstring of the module is complete."""

from __future__ import annotations

import inspect
import re

from knifetip import errors


def test_the_tree_names_every_class_under_its_base() -> None:
    drawn: dict[str, str] = {}
    above = ["KnifetipError"]
    for line in (errors.__doc__ or "").splitlines():
        if found := re.match(r"^    ((?:│   |    )*)[├└]── (\w+)", line):
            depth = len(found[1]) // 4 + 1
            above = [*above[:depth], found[2]]
            drawn[found[2]] = above[depth - 1]
    defined = {
        name: one.__bases__[0].__name__
        for name, one in inspect.getmembers(errors, inspect.isclass)
        if issubclass(one, errors.KnifetipError) and one is not errors.KnifetipError
    }
    assert drawn == defined
