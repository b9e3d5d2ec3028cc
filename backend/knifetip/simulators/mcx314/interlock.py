"""interlock: conditions that prevent motion: an alarm, the button, axes that are not homed."""

from __future__ import annotations

from dataclasses import dataclass, field

from knifetip.simulators.mcx314.refusal import RequestRefused


@dataclass(slots=True)
class Interlock:
    """Alarm, emergency stop button and homing of a board."""

    homed: bool
    alarm: str = field(init=False)  #: such as ``limit-X``; empty for none
    pressed: bool = False  #: the emergency stop button is pressed

    def __post_init__(self) -> None:
        self.alarm = self._of_homing()

    def trip(self, alarm: str) -> None:
        """Record an alarm; the chip has stopped at once, so the position may be wrong."""
        self.alarm = alarm
        self.homed = False

    def unlock(self) -> None:
        """Clear the alarm, but not that of axes that are not homed.

        Raises
        ------
        RequestRefused
            The button is pressed.
        """
        self._require_released()
        if self.alarm:
            self.alarm = self._of_homing()

    def begin_homing(self) -> None:
        """Clear every alarm, because the axes are homed now.

        Raises
        ------
        RequestRefused
            The button is pressed.
        """
        self._require_released()
        self.alarm = ""

    def require_clear(self) -> None:
        """Raise ``RequestRefused`` if there is an alarm."""
        if self.alarm:
            raise RequestRefused("alarm", self.alarm)

    def _require_released(self) -> None:
        if self.pressed:
            raise RequestRefused("alarm", "emergency")

    def _of_homing(self) -> str:
        return "" if self.homed else "unhomed"
