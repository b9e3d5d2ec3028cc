"""compiled: how kernels are compiled that make no array and keep none.

Without numba's counting of references, which takes longer at every turn than what such a kernel
does there, by instructions that wait for the other cores.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, TypeVar

from numba import njit

_Function = TypeVar("_Function", bound=Callable[..., Any])

_UNCOUNTED: Final[dict[str, Any]] = {"cache": True, "error_model": "numpy", "_nrt": False}


def part(function: _Function) -> _Function:
    """Compile what becomes one piece with its caller: calls with a dozen tables take time."""
    compiled: _Function = njit(**_UNCOUNTED, forceinline=True)(function)
    return compiled


def whole(function: _Function) -> _Function:
    """Compile what is called as it is, and by several cores at once."""
    compiled: _Function = njit(**_UNCOUNTED, nogil=True)(function)
    return compiled
