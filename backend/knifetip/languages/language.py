"""language: the record that describes one controller language (HPGL or a dialect of RS274/NGC).

A record names its components as "module:attribute"; a component is imported when it is first used.
Each component has an interface that is defined as a protocol in the package of the component, for
example ``post.emit.Emitter`` for the emitter.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from knifetip.errors import ControllerError
from knifetip.fields import InvalidFields
from knifetip.messages import Message
from knifetip.model.machine import Machine


@dataclass(frozen=True, slots=True)
class Language:
    """Name and components of one controller language.

    Examples
    --------
    Another package declares its record as an entry point::

        [project.entry-points."knifetip.languages"]
        example = "knifetip_example:LANGUAGE"
    """

    name: str  #: value of ``dialect`` in the machine's TOML file
    title: str  #: name for operators
    suffix: str  #: suffix of program files, with its dot
    emitter: str  #: path of a ``knifetip.post.emit.Emitter``
    reader: str  #: path of a ``knifetip.verification.reading.moves.ProgramReader``
    timing: str  #: path of a ``knifetip.sequencing.timing.Timing``
    driver: str = ""  #: path of a ``knifetip.gateway.controller.Driver``, or empty
    no_driver: Message | None = None  #: advice how to send a program without the gateway
    #: path of the function that serves a simulated controller on a TCP port
    simulator: str = "knifetip.simulators.grbl.simulator:serve"
    settings: str = ""  #: path of the function that reads ``[controller]``, or empty
    settings_table: str = ""  #: path of the pydantic model of ``[controller]``, for editors
    #: path of the function that returns the lines that set the settings of a machine's controller
    setting_lines: str = ""
    linear_axes: str = "XYZ"  #: letters of the words that move linear axes (mm)
    rotary_axes: str = "C"  #: letters of the words that turn rotary axes (degrees)
    #: whether programs set the depth and the heading of a tool; otherwise the controller does, and
    #: a knife makes one pass at one feed
    sets_pose: bool = True
    #: digital outputs of a controller whose machine does not state them; 0 if that differs
    default_outputs: int = 0

    def load_part(self, role: str) -> Any:
        """Import and return one component of the language.

        ``role`` is the field that names the component: ``emitter``, ``reader``, ``timing``,
        ``driver``, ``simulator``, ``settings``, ``settings_table`` or ``setting_lines``.
        """
        return pkgutil.resolve_name(getattr(self, role))

    def load_driver(self, machine: Machine) -> Any:
        """Import and return the gateway driver of the language, which sends programs to the
        controller of ``machine``.

        Raises
        ------
        ControllerError
            The language has no driver, or the machine has several carriages.  The gateway follows
            and lifts one head, so it cannot bring a machine with several into a safe state.
        """
        if not self.driver:
            raise ControllerError("language.no-driver", language=self.title, advice=self.no_driver)
        if machine.gantry:
            count = len(machine.carriages)
            raise ControllerError("controller.one-carriage", machine=machine.title, count=count)
        return self.load_part("driver")

    def read_settings(self, fields: Mapping[str, Any], machine: Machine) -> object:
        """Return the validated controller settings of a machine, or None if the language has no
        settings.

        ``fields`` is the table ``[controller]`` of the machine's TOML file.

        Raises
        ------
        InvalidFields
            The table is invalid, or has fields although the language has no settings, or the
            language cannot drive the machine, for example because it has no word for an axis.
        """
        self._check_axes(machine)
        self._check_outputs(machine)
        if self.settings:
            return self.load_part("settings")(fields, machine)
        if fields:
            fault = Message("language.no-settings", path="controller", language=self.title)
            raise InvalidFields([fault], ("controller",))
        return None

    def _check_outputs(self, machine: Machine) -> None:
        """Raise ``InvalidFields`` if a station or a tool needs an output that does not exist."""
        count = machine.output_count or self.default_outputs
        missing = [str(output) for output in machine.outputs if output >= count]
        if count and missing:
            code = "language.few-outputs" if machine.output_count else "language.default-outputs"
            fault = Message(code, outputs=missing, count=count, language=self.title)
            raise InvalidFields([fault], ("output_count",))

    def _check_axes(self, machine: Machine) -> None:
        """Raise ``InvalidFields`` if the language has no word for an axis of a carriage."""
        for number, carriage in enumerate(machine.carriages, 1):
            for place, letter in enumerate(carriage.letters):
                known = self.rotary_axes if place == 3 else self.linear_axes
                if letter not in known:
                    code = "language.no-rotary-axis" if place == 3 else "language.no-linear-axis"
                    fault = Message(
                        code,
                        letter=letter,
                        carriage=number,
                        language=self.title,
                        known=list(known),
                    )
                    first = ("axes", "c", "letter")
                    raise InvalidFields([fault], first if number == 1 else ("gantry", "carriage"))
