"""Find the message codes of the errors that a function can raise, by reading the source.

The calls of a function are followed where they can be resolved: names of its module, methods of its
class, and repositories of the store (``service.store.jobs.get``).  Calls of worker processes are
not followed.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import typing
from collections.abc import Callable, Iterator
from functools import cache
from types import FunctionType, ModuleType
from typing import Any

from knifetip import errors
from knifetip.messages.codes import CODES
from knifetip.service.refusals.error_status import status_of
from knifetip.service.store import Store


def raised(function: Callable[..., Any]) -> set[tuple[int, str]]:
    """Return status and code of the errors that a function can raise."""
    found: set[tuple[int, str]] = set()
    seen: set[Callable[..., Any]] = set()
    waiting = [function]
    while waiting:
        one = inspect.unwrap(waiting.pop())
        if not isinstance(one, FunctionType) or one in seen:
            continue
        seen.add(one)
        own, called = _read(one)
        found |= own
        waiting += called
    return found


def _caught(tree: ast.AST) -> set[ast.AST]:
    """Return the nodes whose errors are caught, whatever their codes."""
    return {
        inner
        for node in ast.walk(tree)
        if isinstance(node, ast.Try)
        and any(
            isinstance(handler.type, ast.Name)
            and handler.type.id == "KnifetipError"
            and not any(isinstance(one, ast.Raise) for one in ast.walk(handler))
            for handler in node.handlers
        )
        for statement in node.body
        for inner in ast.walk(statement)
    }


@cache
def _read(function: FunctionType) -> tuple[frozenset[tuple[int, str]], tuple[Any, ...]]:
    module = importlib.import_module(function.__module__)
    if not module.__name__.startswith(("knifetip.server", "knifetip.service", "knifetip.library")):
        return frozenset(), ()
    tree = _node(module, function)
    if tree is None:
        return frozenset(), ()
    owner = _owner(module, function)
    codes: set[tuple[int, str]] = set()
    called: list[Any] = []
    caught = _caught(tree)
    for node in ast.walk(tree):
        if node in caught:
            continue
        if isinstance(node, ast.Call):
            codes |= set(_codes(node, module))
        if isinstance(node, (ast.Attribute, ast.Name)):
            target = _resolve(node, module, owner)
            if isinstance(target, type) and _is_made_for_requests(target):
                target = inspect.getattr_static(target, "__init__")
            if callable(target):
                called.append(target)
    return frozenset(codes), tuple(called)


def _is_made_for_requests(kind: type) -> bool:
    """Return whether objects of a class are made for requests, unlike repositories."""
    module = kind.__module__
    return module.startswith("knifetip.service.") and not (
        module.endswith("store") or module.startswith("knifetip.service.database.")
    )


def _node(module: ModuleType, function: FunctionType) -> ast.AST | None:
    line = function.__code__.co_firstlineno
    for node in ast.walk(_tree(module)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            first = min([node.lineno, *(one.lineno for one in node.decorator_list)])
            if node.name == function.__name__ and first == line:
                return node
    return None


@cache
def _tree(module: ModuleType) -> ast.AST:
    return ast.parse(inspect.getsource(module))


def _owner(module: ModuleType, function: FunctionType) -> type | None:
    name, _, _ = function.__qualname__.rpartition(".")
    found = getattr(module, name, None)
    return found if isinstance(found, type) else None


def _codes(call: ast.Call, module: ModuleType) -> Iterator[tuple[int, str]]:
    kind = getattr(module, call.func.id, None) if isinstance(call.func, ast.Name) else None
    if not (isinstance(kind, type) and issubclass(kind, errors.KnifetipError)):
        return
    status = status_of(kind.__new__(kind))
    first = call.args[0] if call.args else None
    for option in ast.walk(first) if first is not None else ():
        if isinstance(option, ast.Constant) and option.value in CODES:
            yield (404 if option.value == "library.unknown" else status), str(option.value)
    if inspect.getattr_static(kind, "__init__") is not errors.KnifetipError.__init__:
        for node in ast.walk(ast.parse(inspect.getsource(kind))):
            if isinstance(node, ast.Constant) and node.value in CODES:
                yield status, str(node.value)


def _resolve(node: ast.expr, module: ModuleType, owner: type | None) -> Any:
    """Return the function that an expression names, None if it cannot be found."""
    if isinstance(node, ast.Name):
        return getattr(module, node.id, None)
    if not isinstance(node, ast.Attribute):
        return None
    if isinstance(node.value, ast.Name) and node.value.id == "self":
        return getattr(owner, node.attr, None)
    kind = _kind(node.value, owner)
    if kind is not None:
        return getattr(kind, node.attr, None)
    base = _resolve(node.value, module, owner)
    return getattr(base, node.attr, None) if isinstance(base, ModuleType) else None


def _kind(node: ast.expr, owner: type | None) -> type | None:
    """Return the class of ``self.NAME`` or ``…store.NAME``."""
    if not isinstance(node, ast.Attribute):
        return None
    inner = node.value
    if isinstance(inner, ast.Name) and inner.id == "self" and owner is not None:
        return _attributes(owner).get(node.attr)
    if (isinstance(inner, ast.Attribute) and inner.attr == "store") or (
        isinstance(inner, ast.Name) and inner.id == "store"
    ):
        return _attributes(Store).get(node.attr)
    return None


@cache
def _attributes(owner: type) -> dict[str, type]:
    """Return the classes of the attributes that the constructor of a class sets."""
    module = importlib.import_module(owner.__module__)
    tree = ast.parse(inspect.getsource(module))
    found: dict[str, type] = {}
    hints = typing.get_type_hints(inspect.getattr_static(owner, "__init__"))
    for part in ast.walk(tree):
        if not (isinstance(part, ast.ClassDef) and part.name == owner.__name__):
            continue
        for node in ast.walk(part):
            if not isinstance(node, ast.Assign) or not isinstance(node.targets[0], ast.Attribute):
                continue
            value, name = node.value, node.targets[0].attr
            kind: Any = None
            if isinstance(value, ast.Call) and isinstance(value.func, ast.Name):
                kind = getattr(module, value.func.id, None)
            elif isinstance(value, ast.Name):
                kind = hints.get(value.id)
            if isinstance(kind, type):
                found[name] = kind
    return found
