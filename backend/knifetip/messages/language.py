"""language: the record of the texts of all messages in one language."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple, TypeAlias


class Text(NamedTuple):
    """Templates of one message in one language; ``messages.render`` describes them."""

    text: str  #: what is wrong, and where
    hint: str = ""  #: what the user can do; empty if the user can do nothing


#: Texts by the code of their message.
Texts: TypeAlias = Mapping[str, Text]
#: Names of words in arguments, such as units, by the format that names them and by word.
Names: TypeAlias = Mapping[str, Mapping[str, str]]


class Language(NamedTuple):
    """Texts of all messages in one language, with its names of words and its form of numbers."""

    tag: str  #: language tag, such as "en"
    texts: Texts
    names: Names  #: words that a format does not name are written as they are
    conjunction: str  #: word between the last two items of a list
    alternative: str  #: word between the last two items of a list of alternatives
    decimal: str  #: character before the decimals of a number
    group: str  #: character between the thousands of a number
