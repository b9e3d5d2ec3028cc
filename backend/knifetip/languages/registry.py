"""registry: the controller languages, by name.

    "grblhal" -> Language

A module of this room with a ``LANGUAGE`` is a language.  Languages of other packages are entry
points; these are searched only for names that are not found here, since that takes longer.
"""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import replace
from functools import cache
from importlib.metadata import entry_points

from knifetip.errors import LibraryError
from knifetip.languages.language import Language
from knifetip.model.machine import Machine

#: Group of the entry points of controller languages.
GROUP = "knifetip.languages"


def language_names() -> list[str]:
    """Return the names of all languages."""
    return sorted({*_own_names(), *entry_points(group=GROUP).names})


@cache
def find_language(name: str) -> Language:
    """Return the language with a name.

    Raises
    ------
    LibraryError
        There is no such language.
    """
    if name in _own_names():
        language = importlib.import_module(f"{__package__}.{name}").LANGUAGE
    else:
        found = tuple(entry_points(group=GROUP, name=name))
        if not found:
            raise LibraryError("language.unknown", name=name[:80], known=language_names())
        language = found[0].load()
    if not isinstance(language, Language) or language.name != name:
        raise LibraryError("language.bad-entry-point", name=name, group=GROUP)
    return language


def with_language(machine: Machine, name: str) -> Machine:
    """Return the machine with another controller language; unchanged if the name is empty.

    Raises
    ------
    LibraryError
        There is no such language, or it needs settings that the machine's file lacks.
    """
    if name in ("", machine.dialect):
        return machine
    language = find_language(name)
    try:
        settings = language.read_settings({}, machine)
    except ValueError as reason:
        raise LibraryError(
            "language.unusable",
            machine=machine.title,
            language=language.title,
            reason=reason,
            own=machine.dialect,
        ) from reason
    return replace(machine, dialect=name, controller=settings)


@cache
def _own_names() -> frozenset[str]:
    """Return the names of the languages of this package."""
    package = importlib.import_module(__package__)
    modules = {module.name for module in pkgutil.iter_modules(package.__path__)}
    return frozenset(modules - {"language", "registry"})
