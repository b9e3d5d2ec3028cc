"""polling: how often a grbl controller is asked for a status report.

Each report is a chance to notice that the machine has left the path of its program, so reports are
requested as often as firmware and connection permit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

#: Time between two status requests of firmware other than grblHAL while the machine moves (s).
#: grbl 1.1 recommends at most 10 reports per second: its processor also plans the motion.
USUAL = 0.1
#: Time between two status requests of grblHAL while the machine moves (s).
GRBLHAL = 0.05
#: Time between two status requests after answers (s), for grblHAL and for other firmware.
GRBLHAL_SOON, SOON = 0.01, 0.02
#: Longest usual status report, with work offset and overrides (bytes).
REPORT_BYTES = 110
#: Fraction of the connection that reports may use; the rest is for the answers to program lines.
SHARE = 0.25


@dataclass(frozen=True, slots=True)
class Polling:
    """Intervals between two status requests while the machine moves or lines are unanswered."""

    usual: float = USUAL  #: longest time (s)
    soon: float = SOON  #: time if a line was answered, so that the machine is on another move (s)

    @classmethod
    def for_controller(cls, *, grblhal: bool, byte_rate: float) -> Polling:
        """Return the intervals for a controller.

        Parameters
        ----------
        grblhal
            Whether the firmware is grblHAL.
        byte_rate
            Bytes per second that the controller can send; infinite if nothing limits them.
        """
        least = REPORT_BYTES / (SHARE * byte_rate) if math.isfinite(byte_rate) else 0.0
        usual, soon = (GRBLHAL, GRBLHAL_SOON) if grblhal else (USUAL, SOON)
        return cls(max(usual, least), max(soon, least))

    @classmethod
    def every(cls, seconds: float) -> Polling:
        """Return intervals of at most ``seconds``."""
        return cls(seconds, min(SOON, seconds))
