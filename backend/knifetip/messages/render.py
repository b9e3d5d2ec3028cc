"""render: render the text and the hint of a message with the templates of a catalogue.

Templates are those of ``str.format``, with these additional formats:

=================  ==================================================================
``{n:# edge|# edges}``  the first form for 1, else the second; ``#`` is the number
``{names:, }``     the items of a list, separated by the text after the colon
``{names:or}``     the items of a list: A, B or C
``{size:MB}``      a number of bytes in mebibytes
``{size:mm}``      a length (mm) with a suitable number of decimals
``{unit:unit}``    the name of a unit of length
``{tool:tool}``    the name of a tool
=================  ==================================================================

An argument that is a message is replaced by its text, or with ``{error:hint}`` by its hint.  A list
of messages is replaced by their texts, or with ``{faults:hint}`` by their hints.  An argument that
is None is replaced by an empty text.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from string import Formatter
from typing import Any, Final

from knifetip.messages import english
from knifetip.messages.characters import printable
from knifetip.messages.message import Message, from_json


def render(message: Message) -> str:
    """Return the text of a message in English."""
    return _FORMATTER.vformat(english.TEXTS[message.code], (), message.arguments)


def hint(message: Message) -> str:
    """Return the English hint of a message: what the user can do; empty if there is no hint."""
    text = _FORMATTER.vformat(english.HINTS.get(message.code, ""), (), message.arguments)
    return text.strip()  # a hint may begin or end with the empty hint of an argument


def with_text(given: Message | Mapping[str, Any] | str) -> dict[str, Any]:
    """Return a message as JSON data, with its English text and hint added.

    The keys are "code", "arguments", "text" and "hint".

    Parameters
    ----------
    given
        A message, its JSON data (further keys are kept), or a sentence that an older version of
        knifetip stored.
    """
    message = given if isinstance(given, Message) else from_json(given)
    return {
        **(given if isinstance(given, Mapping) else {}),
        **message.as_json(),
        "text": printable(render(message)),
        "hint": printable(hint(message)),
    }


class _Formatter(Formatter):
    def format_field(self, value: Any, format_spec: str) -> Any:
        match value:
            case None:
                return ""
            case Message():
                return hint(value) if format_spec == "hint" else render(value)
            case tuple():
                if format_spec == "hint":
                    return " ".join(dict.fromkeys(filter(None, map(hint, value))))
                items = [self.format_field(item, "") for item in value]
                if format_spec == "or":
                    return " or ".join([", ".join(items[:-1]), *items[-1:]]).removeprefix(" or ")
                return (format_spec or ", ").join(items)
            case _ if format_spec in _NAMED:
                return _NAMED[format_spec](value)
            case _ if "|" in format_spec:
                one, many = format_spec.split("|")
                return (one if value == 1 else many).replace("#", f"{value:,}")
            case _:
                return super().format_field(value, format_spec)


def _length(size: float) -> str:
    return f"{size:.0f}" if abs(size) >= 1000.0 else f"{size:.1f}" if size >= 1 else f"{size:.3g}"


_NAMED: Final[Mapping[str, Callable[[Any], str]]] = {
    "MB": lambda size: f"{size / 2**20:.1f}",
    "mm": _length,
    "unit": lambda unit: english.UNITS.get(unit, unit),
    "tool": lambda tool: english.TOOLS.get(tool, tool),
}
_FORMATTER: Final = _Formatter()
