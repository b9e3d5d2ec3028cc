"""entry: the record of one message in the catalogue: types of its arguments, text and hint."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple, TypeAlias

#: Types: str, int, float, list of str, another message, a message or None, list of messages; the
#: row of an edge, a list of such rows, and the position of a place in the drawing along x and y
#: (mm).
Kind: TypeAlias = Literal[
    "text", "count", "number", "texts", "message", "message?", "messages", "edge", "edges", "x", "y"
]


class Entry(NamedTuple):
    """One message in the catalogue: English templates of text and hint, and types of the arguments.

    ``messages.render`` describes the templates.
    """

    text: str  #: English template: what is wrong, and where
    hint: str  #: English template: what the user can do; empty if the user can do nothing
    arguments: Mapping[str, Kind]  #: type of each argument, by name


#: Messages by code.
Entries: TypeAlias = Mapping[str, Entry]


def entry(text: str, hint: str = "", /, **arguments: Kind) -> Entry:
    """Return the catalogue entry of a message.

    Parameters
    ----------
    text
        English template of the text, as described in ``messages.render``.
    hint
        English template of the hint; "" if the user can do nothing.
    arguments
        Types of the arguments of the message, as keyword arguments.
    """
    return Entry(text, hint, arguments)
