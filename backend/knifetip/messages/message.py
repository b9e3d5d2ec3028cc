"""message: the record of one message: a code with its arguments, without the text."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Mapping
from pathlib import PurePath
from typing import Any, Final, Protocol, TypeAlias, runtime_checkable

from knifetip.messages.characters import printable
from knifetip.messages.codes import CODES, STORED
from knifetip.messages.entry import Kind

#: Value in JSON for numbers that are infinite or not a number, which JSON cannot represent.
_NOT_FINITE: Final = 1e9
#: Characters of unusable arguments that are shown.
_SHOWN: Final = 300


@runtime_checkable
class _Number(Protocol):
    """Protocol of Python and NumPy numbers, which convert to float and int."""

    def __float__(self) -> float: ...

    def __int__(self) -> int: ...


Argument: TypeAlias = (
    "str | _Number | PurePath | BaseException | Message | Iterable[str] | Iterable[_Number] "
    "| Iterable[Message] | None"
)


class Message:
    """One message for the user: a code and its arguments, without the text.

    Parameters
    ----------
    code
        A key of ``codes.CODES``.
    arguments
        Values of the arguments that ``codes.CODES`` lists for the code, as keyword arguments.
        NumPy numbers become Python numbers.

    Raises
    ------
    TypeError
        The code is unknown, or an argument is missing or not listed for the code.
    """

    __slots__ = ("_key", "arguments", "code")

    code: str
    arguments: Mapping[str, Any]

    def __init__(self, code: str, /, **arguments: Argument) -> None:
        kinds = CODES.get(code)
        if kinds is None or kinds.keys() != arguments.keys():
            wanted = "is not listed" if kinds is None else f"takes {', '.join(kinds) or 'nothing'}"
            raise TypeError(f"the code {code} {wanted}; given: {', '.join(arguments) or 'nothing'}")
        self.code = code
        self.arguments = {name: _CAST[kinds[name]](value) for name, value in arguments.items()}
        self._key = (code, tuple(self.arguments[name] for name in kinds))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Message) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    def __repr__(self) -> str:
        given = "".join(f", {name}={value!r}" for name, value in self.arguments.items())
        return f"Message({self.code!r}{given})"

    def __str__(self) -> str:
        from knifetip.messages.render import render

        return render(self)

    def __reduce__(self) -> tuple[object, ...]:
        return (_rebuild, (self.code, self.arguments))

    def located(
        self, row_of: Callable[[int], int], shift: tuple[float, float] = (0.0, 0.0)
    ) -> Message:
        """Return the message with converted edges and positions, also in messages in its arguments.

        Planning counts cleaned edges at their position on the table; users know the drawn ones.

        Parameters
        ----------
        row_of
            Returns the new row of an edge.
        shift : mm
            Is added to the positions along x and y.
        """

        def moved(kind: Kind, value: Any) -> Any:
            match kind:
                case "edge":
                    return row_of(value)
                case "edges":
                    return tuple(dict.fromkeys(map(row_of, value)))
                case "x" | "y":
                    return value + shift[kind == "y"]
            if isinstance(value, tuple):
                return tuple(moved("message", item) for item in value)
            return value.located(row_of, shift) if isinstance(value, Message) else value

        kinds = CODES[self.code]
        arguments = {name: moved(kinds[name], value) for name, value in self.arguments.items()}
        return Message(self.code, **arguments)

    def as_json(self) -> dict[str, Any]:
        """Return the message as a dictionary for JSON, with the keys "code" and "arguments"."""
        arguments = {name: _plain(value) for name, value in self.arguments.items()}
        return {"code": self.code, "arguments": arguments}


def from_json(plain: Mapping[str, Any] | str) -> Message:
    """Return the message from the JSON data that ``Message.as_json`` returned.

    Older versions of knifetip stored a sentence in place of this data.  Such a sentence becomes a
    message with the code ``stored.text``.  So does the stored text of a message whose code is
    unknown to this version of knifetip, or whose arguments are not those of its code.  If it has no
    text, its code and the arguments as they are take the place of the text.
    """
    if isinstance(plain, str):
        return Message(STORED, text=plain, hint="")
    kinds = CODES.get(str(plain.get("code")))
    given = plain.get("arguments") or {}
    if kinds is None or kinds.keys() != given.keys():
        text = str(plain.get("text", "")) or _unrendered(plain)
        return Message(STORED, text=text, hint=str(plain.get("hint", "")))
    return Message(
        plain["code"], **{name: _restore_argument(value) for name, value in given.items()}
    )


def _unrendered(plain: Mapping[str, Any]) -> str:
    """Return code and arguments of a message that has no text, in one line of printable letters."""
    code, given = plain.get("code"), plain.get("arguments")
    if not code:
        return ""
    arguments = json.dumps(given, ensure_ascii=False, default=str) if given else ""
    shown = f"{arguments[:_SHOWN]}…" if len(arguments) > _SHOWN else arguments
    text = f"{str(code)[:100]} {shown}".strip()
    return "".join(letter if letter.isprintable() else "\ufffd" for letter in text)


def _rebuild(code: str, arguments: Mapping[str, Any]) -> Message:
    return Message(code, **arguments)


def _restore_argument(value: Any) -> Any:
    if isinstance(value, Mapping):
        return from_json(value)
    if isinstance(value, list):
        return [_restore_argument(item) for item in value]
    return value


def _plain(value: Any) -> Any:
    match value:
        case Message():
            return value.as_json()
        case tuple():
            return [_plain(item) for item in value]
        case str():
            return printable(value)
        case float():
            return finite(value)
        case _:
            return value


def finite(number: float) -> float:
    """Return a number unchanged if it is finite, else a number that JSON can represent.

    This number is 1e9 for infinity, -1e9 for minus infinity, and 1e9 for NaN.
    """
    if math.isfinite(number):
        return float(number)
    return -_NOT_FINITE if number < 0.0 else _NOT_FINITE


def _texts(value: Iterable[object]) -> tuple[str, ...]:
    if isinstance(value, str):
        raise TypeError(f"{value!r} is one text, not a list of them")
    return tuple(str(item) for item in value)


def _message(value: object) -> Message:
    """Return the message that a stored value represents.

    A ``Message`` is returned unchanged.  Any other value becomes the text of a message with the
    code ``stored.text``, because older versions of knifetip stored a text in place of a message.
    """
    return value if isinstance(value, Message) else Message(STORED, text=str(value), hint="")


_CAST: Final[Mapping[Kind, Any]] = {
    "text": str,
    "count": int,
    "number": float,
    "texts": _texts,
    "message": _message,
    "message?": lambda value: None if value is None else _message(value),
    "messages": lambda value: tuple(map(_message, value)),
    "edge": int,
    "edges": lambda value: tuple(map(int, value)),
    "x": float,
    "y": float,
}
