"""Access to names that a module imports and a test replaces."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any


def original(module: ModuleType, name: str) -> Callable[..., Any]:
    """Return a function by the name under which a module calls it.

    Type checkers refuse ``module.name`` where the module has imported the name itself.
    """
    found: Callable[..., Any] = getattr(module, name)
    return found
