"""language: the record that describes one controller language.

A record is light: it names its parts as "module:attribute", and each is imported when it is first
used.  The protocols say what the parts must be; their types are those of ``model``, but for the
judge's moves, which belong to ``verification``.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from knifetip.errors import ControllerError
from knifetip.model.machine import Machine


@dataclass(frozen=True, slots=True)
class Language:
    """One controller language.

    Examples
    --------
    A package of its own declares its record as an entry point::

        [project.entry-points."knifetip.languages"]
        example = "knifetip_example:LANGUAGE"
    """

    name: str  #: ``dialect`` in the machine's TOML
    title: str  #: name for operators
    suffix: str  #: of a program's file, with its dot
    emitter: str  #: a ``knifetip.post.emit.Emitter``
    reader: str  #: a ``knifetip.verification.reading.moves.ProgramReader``
    timing: str  #: a ``knifetip.sequencing.timing.Timing``
    driver: str = ""  #: a ``knifetip.gateway.controller.Driver``; empty: programs are not streamed
    no_driver: str = ""  #: hint where there is no driver: how a program gets to the machine
    settings: str = ""  #: reads ``[controller]`` of a machine's TOML; empty: there is no such table

    def part(self, role: str) -> Any:
        """Return the ``emitter``, ``reader`` or ``timing`` of this language."""
        return pkgutil.resolve_name(getattr(self, role))

    def dial(self) -> Any:
        """Return the gateway driver.

        Raises
        ------
        ControllerError
            The language has none.
        """
        if not self.driver:
            raise ControllerError("language.no-driver", language=self.title, advice=self.no_driver)
        return self.part("driver")

    def read_settings(self, fields: Mapping[str, Any], machine: Machine) -> object:
        """Return what ``[controller]`` of a machine's TOML says, checked by the language.

        Raises
        ------
        ValueError
            The table is wrong, the language has none, or it cannot drive such a machine.
        """
        if self.settings:
            return self.part("settings")(fields, machine)
        if fields:
            raise ValueError(f"{self.title} has no settings, so there is no [controller]")
        return None
