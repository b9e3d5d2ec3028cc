"""Access to functions that a module imports and that a test replaces."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any


def original(module: ModuleType, name: str) -> Callable[..., Any]:
    """Return the function that a module has imported under a name.

    Type checkers reject ``module.name`` if the module has imported the name itself.
    """
    found: Callable[..., Any] = getattr(module, name)
    return found
