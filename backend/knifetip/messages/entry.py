"""entry: the record of one message of the catalogue: types of its arguments, text and hint."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple, TypeAlias

#: Types: str, int, float, list of str, another message, a message or None, list of messages.
Kind: TypeAlias = Literal["text", "count", "number", "texts", "message", "message?", "messages"]


class Entry(NamedTuple):
    """One message of the catalogue; its templates are described in ``messages.render``."""

    text: str  #: English template: what is wrong, and where
    hint: str  #: English template: what the user can do; empty if the user can do nothing
    arguments: Mapping[str, Kind]  #: type of each argument, by name


#: Messages by code.
Entries: TypeAlias = Mapping[str, Entry]


def entry(text: str, hint: str = "", /, **arguments: Kind) -> Entry:
    """Return the catalogue entry of a message.

    Parameters
    ----------
    text, hint
        English templates of the text and the hint.
    arguments
        Type of each argument, as keyword arguments.
    """
    return Entry(text, hint, arguments)
