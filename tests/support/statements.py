"""SQL statements that the tests of a process compile once, though each has its own database."""

from __future__ import annotations

from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Mapper
from sqlalchemy.util import LRUCache

#: More statements than knifetip has.
_MOST = 20_000


class _Compiled(LRUCache[Any, Any]):
    """Compiled statements by their keys, in which the kind of database replaces the engine's own.

    SQLAlchemy keeps the statements of each engine apart. To compile those of a new engine takes a
    third of the CPU time of a test of the store.
    """

    def get(self, key: Any, default: Any = None) -> Any:
        return super().get(_for_all_engines(key), default)

    def __setitem__(self, key: Any, value: Any) -> None:
        super().__setitem__(_for_all_engines(key), value)


def _for_all_engines(key: tuple[Any, ...]) -> tuple[Any, ...]:
    return type(key[0]), *key[1:]


def share_compiled_statements(patch: pytest.MonkeyPatch) -> None:
    """Let all engines that this process makes use the statements which others have compiled."""
    compiled = _Compiled(_MOST)
    original = sa.Engine.__init__

    def init(engine: sa.Engine, *arguments: Any, **options: Any) -> None:
        original(engine, *arguments, **options)
        engine._compiled_cache = compiled

    patch.setattr(sa.Engine, "__init__", init)
    # Those that add and change rows of a class.
    patch.setattr(Mapper, "_compiled_cache", compiled)
