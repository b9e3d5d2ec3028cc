"""Attributes of table rows whose bytes are in the content store and loaded on request."""

from __future__ import annotations

from typing import Any, Final, Self, overload

_LOADED: Final = "_loaded_"


class LargeValue:
    """Bytes that belong to a row; the column ``NAME_address`` has their address.

    Reading the attribute before ``ContentStore`` has loaded it raises ``AttributeError``.
    """

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    @overload
    def __get__(self, row: None, owner: type) -> Self: ...
    @overload
    def __get__(self, row: object, owner: type) -> bytes: ...
    def __get__(self, row: object | None, owner: type) -> Self | bytes:
        if row is None:
            return self
        try:
            value: bytes = row.__dict__[_LOADED + self._name]
        except KeyError:
            raise AttributeError(f"{owner.__name__}.{self._name} is not loaded") from None
        return value

    def __set__(self, row: Any, value: bytes) -> None:
        row.__dict__[_LOADED + self._name] = value
