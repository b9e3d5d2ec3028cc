"""registry: find controller languages by name.

Each module of this package that defines ``LANGUAGE`` is a language.  Other packages register
languages as entry points.  A name is first looked up among the modules of this package, and only
then among the entry points, because a search of entry points takes longer.
"""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import replace
from functools import cache
from importlib.metadata import entry_points

from knifetip.errors import LibraryError
from knifetip.fields import InvalidFields
from knifetip.languages.language import Language
from knifetip.model.machine import Machine

#: Group of the entry points of controller languages.
GROUP = "knifetip.languages"


def language_names() -> list[str]:
    """Return the names of all controller languages, of this package and of entry points."""
    return sorted({*_built_in_names(), *entry_points(group=GROUP).names})


@cache
def find_language(name: str) -> Language:
    """Return the record of the controller language with a name such as ``linuxcnc`` or ``hpgl``.

    Raises
    ------
    LibraryError
        There is no language with this name, or another package registers an invalid record for it.
    """
    if name in _built_in_names():
        language = importlib.import_module(f"{__package__}.{name}").LANGUAGE
    else:
        candidates = tuple(entry_points(group=GROUP, name=name))
        if not candidates:
            raise LibraryError("language.unknown", name=name[:80], known=language_names())
        language = candidates[0].load()
    if not isinstance(language, Language) or language.name != name:
        raise LibraryError("language.bad-entry-point", name=name, group=GROUP)
    return language


def with_language(machine: Machine, name: str) -> Machine:
    """Return a copy of a machine whose controller language is replaced by the language ``name``.

    If the name is empty or is the name of the machine's own language, the machine is returned
    unchanged.

    Raises
    ------
    LibraryError
        There is no language with this name, or the language cannot drive the machine, for example
        because it needs settings.
    """
    if name in ("", machine.dialect):
        return machine
    language = find_language(name)
    try:
        settings = language.read_settings({}, machine)
    except InvalidFields as reason:
        raise LibraryError(
            "language.unusable",
            machine=machine.title,
            language=language.title,
            faults=reason.faults,
            own=machine.dialect,
        ) from reason
    return replace(machine, dialect=name, controller=settings)


@cache
def _built_in_names() -> frozenset[str]:
    """Return the names of the controller languages that are modules of this package."""
    package = importlib.import_module(__package__)
    modules = {module.name for module in pkgutil.iter_modules(package.__path__)}
    return frozenset(modules - {"language", "registry"})
