"""render: render the text and the hint of a message with the templates of a language.

Templates are those of ``str.format``, with these formats:

=======================  =======================================================================
``{n:# edge|# edges}``   the first form for 1, else the second; ``#`` is the number
``{names:, }``           the items of a list, separated by the text after the colon
``{names: and }``        the same with a word of the language
``{names:or}``           the items of a list: A, B or C
``{size:.2f}``           a number with two decimals
``{size:g}``             a number with at most 6 significant digits, ``.3g`` with at most 3
``{count:,}``            a whole number
``{size:mm}``            a length (mm) with a suitable number of decimals
``{size:MB}``            a number of bytes in mebibytes
``{unit:unit}``          the name of a unit of length
``{tool:tool}``          the name of a tool
``{type:type}``          the name of a line type; also ``state``, ``stage``, ``request``, ``shelf``,
                         ``kind`` and ``parameter``
=======================  =======================================================================

Numbers are written in the form of the language, with characters between thousands and without an
exponent: 1,200 mm.  Coordinates, which have the kinds ``x`` and ``y``, have no characters between
thousands.  Counts without a format are numbers of lines, edges and stations, which are written with
their digits alone.  An argument that is a message is replaced by its text, or with ``{error:hint}``
by its hint.  A list of messages is replaced by their texts, or with ``{faults:hint}`` by their
hints.  An argument that is None is replaced by an empty text, and blanks at both ends of the result
are removed: a template may end with a sentence that is not always there.
"""

from __future__ import annotations

from collections.abc import Mapping
from string import Formatter
from typing import Any, Final

from knifetip.messages.characters import printable
from knifetip.messages.codes import CODES
from knifetip.messages.english import ENGLISH
from knifetip.messages.language import Language
from knifetip.messages.languages import language as language_of
from knifetip.messages.message import Message, from_json
from knifetip.messages.numbers import Position, write_number

#: Formats that name a word in an argument.  Words without a name are written as they are.
NAMED: Final = ("unit", "tool", "type", "state", "stage", "request", "shelf", "kind", "parameter")


def render(message: Message, language: str = ENGLISH.tag) -> str:
    """Return the text of a message in a language.

    Parameters
    ----------
    message
        The message.
    language
        Tag of the language.  A message that the language lacks is rendered in English as a whole.

    Raises
    ------
    KeyError
        knifetip has no messages in this language.
    """
    chosen = _language(message, language)
    return _format_value(message, chosen.texts[message.code].text, chosen)


def hint(message: Message, language: str = ENGLISH.tag) -> str:
    """Return the hint of a message: what the user can do; empty if there is no hint.

    Parameters
    ----------
    message
        The message.
    language
        Tag of the language, as in ``render``.

    Raises
    ------
    KeyError
        knifetip has no messages in this language.
    """
    chosen = _language(message, language)
    return _format_value(message, chosen.texts[message.code].hint, chosen)


def with_text(
    given: Message | Mapping[str, Any] | str, language: str = ENGLISH.tag
) -> dict[str, Any]:
    """Return a message as JSON data, with its text and hint in a language added.

    The keys are "code", "arguments", "text" and "hint".

    Parameters
    ----------
    given
        A message, its JSON data (further keys are kept), or a sentence that an older version of
        knifetip stored.
    language
        Tag of the language, as in ``render``.

    Raises
    ------
    KeyError
        knifetip has no messages in this language.
    """
    message = given if isinstance(given, Message) else from_json(given)
    return {
        **(given if isinstance(given, Mapping) else {}),
        **message.as_json(),
        "text": printable(render(message, language)),
        "hint": printable(hint(message, language)),
    }


def _language(message: Message, tag: str) -> Language:
    """Return the language of a message: English if the chosen one lacks it or a message in it."""
    chosen = language_of(tag)
    return chosen if _is_complete(message, chosen) else ENGLISH


def _is_complete(message: Message, language: Language) -> bool:
    """Return whether a language has the texts of a message and of the messages in it."""
    if language is ENGLISH:
        return True
    if message.code not in language.texts:
        return False
    return all(_is_complete(inner, language) for inner in _inner(message))


def _inner(message: Message) -> list[Message]:
    """Return the messages in the arguments of a message."""
    found = []
    for value in message.arguments.values():
        items = value if isinstance(value, tuple) else (value,)
        found += [item for item in items if isinstance(item, Message)]
    return found


def _format_value(message: Message, template: str, language: Language) -> str:
    """Return a template with the arguments of a message, without blanks at both ends."""
    kinds = CODES[message.code]
    arguments = {
        name: Position(value) if kinds[name] in ("x", "y") else value
        for name, value in message.arguments.items()
    }
    return _Formatter(language).vformat(template, (), arguments).strip()


class _Formatter(Formatter):
    def __init__(self, language: Language) -> None:
        self._language = language

    def format_field(self, value: Any, format_spec: str) -> Any:
        language = self._language
        match value:
            case None:
                return ""
            case Message():
                template = language.texts[value.code]
                if format_spec == "hint":
                    return _format_value(value, template.hint, language)
                return _format_value(value, template.text, language)
            case tuple():
                return self._list(value, format_spec)
            case _ if format_spec in NAMED:
                return language.names.get(format_spec, {}).get(value, value)
            case _ if "|" in format_spec:
                one, many = format_spec.split("|")
                number = write_number(value, ",", language)
                return (one if value == 1 else many).replace("#", number)
            case float():
                return write_number(value, format_spec, language)
            case int() if format_spec:
                return write_number(value, format_spec, language)
            case _:
                return super().format_field(value, format_spec)

    def _list(self, items: tuple[Any, ...], format_spec: str) -> str:
        if format_spec == "hint":
            hints = (self.format_field(item, "hint") for item in items)
            return " ".join(dict.fromkeys(filter(None, hints)))
        named = format_spec in NAMED
        texts = [str(self.format_field(item, format_spec if named else "")) for item in items]
        if format_spec == "or" or named:
            word = f" {self._language.alternative} "
            return word.join([", ".join(texts[:-1]), *texts[-1:]]).removeprefix(word)
        return (format_spec or ", ").join(texts)
