"""language: the record that describes one controller language.

A record names its parts as "module:attribute"; a part is imported when it is first used.  Protocols
define the interfaces of the parts.  They use types of ``model``, except the moves of the verifier,
which belong to ``verification``.
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
    """Name and parts of one controller language.

    Examples
    --------
    Another package declares its record as an entry point::

        [project.entry-points."knifetip.languages"]
        example = "knifetip_example:LANGUAGE"
    """

    name: str  #: ``dialect`` in the machine's TOML
    title: str  #: name for operators
    suffix: str  #: suffix of program files, with its dot
    emitter: str  #: a ``knifetip.post.emit.Emitter``
    reader: str  #: a ``knifetip.verification.reading.moves.ProgramReader``
    timing: str  #: a ``knifetip.sequencing.timing.Timing``
    driver: str = ""  #: a ``knifetip.gateway.controller.Driver``; empty if none
    no_driver: str = ""  #: hint if there is no driver: how to send a program to the machine
    settings: str = ""  #: reads ``[controller]`` of a machine's TOML; empty if none

    def load_part(self, role: str) -> Any:
        """Import and return the ``emitter``, ``reader`` or ``timing`` of this language."""
        return pkgutil.resolve_name(getattr(self, role))

    def load_driver(self) -> Any:
        """Import and return the gateway driver.

        Raises
        ------
        ControllerError
            The language has no driver.
        """
        if not self.driver:
            raise ControllerError("language.no-driver", language=self.title, advice=self.no_driver)
        return self.load_part("driver")

    def read_settings(self, fields: Mapping[str, Any], machine: Machine) -> object:
        """Return the settings in ``[controller]`` of a machine's TOML, checked by the language.

        Raises
        ------
        ValueError
            The table is invalid, the language has no settings, or it cannot drive the machine.
        """
        if self.settings:
            return self.load_part("settings")(fields, machine)
        if fields:
            raise ValueError(f"{self.title} has no settings, so there is no [controller]")
        return None
