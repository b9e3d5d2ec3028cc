"""languages: the languages of the messages, and the choice of one for a user."""

from __future__ import annotations

import functools
import importlib
from collections.abc import Iterable, Mapping
from typing import Final

from knifetip.messages.english import ENGLISH
from knifetip.messages.language import Language

#: Module and constant of each further language by its tag; a module is loaded when it is needed.
_FURTHER: Final[Mapping[str, tuple[str, str]]] = {
    "de": ("knifetip.messages.german", "GERMAN"),
}
#: Tags of all languages; English is the language of messages that another one lacks.
LANGUAGES: Final = (ENGLISH.tag, *_FURTHER)


@functools.cache
def language(tag: str) -> Language:
    """Return a language by its tag.

    Raises
    ------
    KeyError
        knifetip has no messages in this language.
    """
    if tag == ENGLISH.tag:
        return ENGLISH
    module, constant = _FURTHER[tag]
    found: Language = getattr(importlib.import_module(module), constant)
    return found


def choose_language(tags: Iterable[str]) -> str:
    """Return the first of some language tags that knifetip has, such as "de" for "de-AT".

    Parameters
    ----------
    tags
        Language tags or names of locales, such as "de-AT" or "de_DE.UTF-8", the best first.
    """
    for tag in tags:
        primary = tag.replace("_", "-").split("-")[0].split(".")[0].strip().lower()
        if primary in LANGUAGES:
            return primary
    return ENGLISH.tag


def accepted_languages(header: str) -> list[str]:
    """Return the language tags of an ``Accept-Language`` header (RFC 9110), the best first.

    Tags with the weight 0 and tags with a weight that is no number are left out.
    """
    weighted: list[tuple[float, str]] = []
    for part in header.split(","):
        tag, _, parameter = part.partition(";")
        name, _, value = parameter.partition("=")
        try:
            weight = float(value) if name.strip().lower() == "q" else 1.0
        except ValueError:
            continue
        if tag.strip() and weight > 0.0:
            weighted.append((weight, tag.strip()))
    return [tag for _, tag in sorted(weighted, key=lambda found: -found[0])]
