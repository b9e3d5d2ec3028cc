"""presupposed: compares the settings of a controller with what its programs presuppose.

A controller has a table of ``Requirement``s, one for each setting that the gateway can read.  A
difference that could damage board, machine or tool is dangerous: the gateway then refuses the
controller.  Any other difference becomes a notice, which the station of the machine shows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from knifetip.errors import ControllerError
from knifetip.messages import Message

#: Relative difference of two velocities or accelerations that does not count.
_EQUAL = 0.01
#: Value of a required setting that the controller does not report.
_MISSING = "?"


@dataclass(frozen=True, slots=True)
class Requirement:
    """What the programs of a machine presuppose of one setting of its controller.

    ``expected`` returns, for the present value of the setting, the value to set; it returns the
    present value if that is right.
    """

    setting: str  #: name of the setting, as the controller writes it
    reason: str  #: code of the message that says why a wrong value matters
    expected: Callable[[str], str]
    dangerous: bool = False
    required: bool = False  #: a controller that does not report the setting is refused or noticed
    #: text that sets the value, with the fields ``setting`` and ``value``
    assignment: str = "{setting}={value}"

    def difference(self, found: str | None) -> Message | None:
        """Return the message about a wrong value; None if it is right, or unknown and not required.

        Parameters
        ----------
        found
            Value of the setting, None if the controller does not report it.
        """
        if found is None and not self.required:
            return None
        value = _MISSING if found is None else found
        if (expected := self.expected(value)) == value:
            return None
        return Message(
            "setting.difference",
            setting=self.setting,
            found=value,
            expected=expected,
            assignment=self.assign(expected),
            reason=Message(self.reason),
        )

    def assign(self, value: str) -> str:
        """Return the text that sets the value at the controller."""
        return self.assignment.format(setting=self.setting, value=value)


@dataclass(frozen=True, slots=True)
class PresupposedSettings:
    """Settings of a controller, and what the programs of its machine presuppose of them."""

    required: Iterable[Requirement] = ()
    found: Mapping[str, str] = field(default_factory=dict)  #: values by the names of the settings
    notices: tuple[Message, ...] = ()  #: why settings could not be read


def compare(
    name: str, requirements: Iterable[Requirement], found: Mapping[str, str]
) -> tuple[Message, ...]:
    """Return notices about the harmless differences between settings and requirements.

    Parameters
    ----------
    name
        Address of the controller, for messages.
    requirements
        Requirements of the machine.
    found
        Values of the settings that the controller reports, by their names.

    Raises
    ------
    ControllerError
        Differences are dangerous; the error contains all of them.
    """
    notices: list[Message] = []
    dangers: list[Message] = []
    for requirement in requirements:
        difference = requirement.difference(found.get(requirement.setting))
        if difference is not None:
            (dangers if requirement.dangerous else notices).append(difference)
    if dangers:
        raise ControllerError("controller.settings-refused", name=name, differences=dangers)
    return tuple(notices)


def number(value: float) -> str:
    """Return a number as controllers write it, without needless zeros."""
    return f"{value:.3f}".rstrip("0").rstrip(".")


def equal_to(wanted: float) -> Callable[[str], str]:
    """Return a condition for ``Requirement.expected``: the setting must have one value."""
    return expect_between(wanted, wanted, wanted)


def at_least(low: float) -> Callable[[str], str]:
    """Return an ``expected`` for a least number."""
    return expect_between(low, float("inf"), low)


def at_most(high: float) -> Callable[[str], str]:
    """Return an ``expected`` for a greatest number."""
    return expect_between(float("-inf"), high, high)


def expect_between(low: float, high: float, wanted: float) -> Callable[[str], str]:
    """Return an ``expected`` for a range of numbers; ``wanted`` is the number to set."""

    def expected(found: str) -> str:
        try:
            fits = low <= float(found) <= high
        except ValueError:
            fits = False
        return found if fits else number(wanted)

    return expected


def not_below(wanted: float) -> Callable[[str], str]:
    """Return an ``expected`` for a positive number that is not less than another one."""
    return expect_between(wanted * (1.0 - _EQUAL), float("inf"), wanted)


def not_above(wanted: float) -> Callable[[str], str]:
    """Return an ``expected`` for a number that is not greater than another one."""
    return expect_between(float("-inf"), wanted * (1.0 + _EQUAL), wanted)


def positive(wanted: str) -> Callable[[str], str]:
    """Return an ``expected`` for a number above zero; ``wanted`` is the value to set."""

    def expected(found: str) -> str:
        return found if at_most(0.0)(found) != found else wanted

    return expected


def bits(on: int = 0, off: int = 0) -> Callable[[str], str]:
    """Return an ``expected`` for a mask of which some bits must be 1, and others 0."""

    def expected(found: str) -> str:
        try:
            mask = int(float(found))
        except ValueError:
            mask = 0
        wanted = (mask | on) & ~off
        return found if wanted == mask else str(wanted)

    return expected


def one_of(*words: str) -> Callable[[str], str]:
    """Return an ``expected`` for a word; the first one is the word to set."""

    def expected(found: str) -> str:
        return found if found.lower() in words else words[0]

    return expected
