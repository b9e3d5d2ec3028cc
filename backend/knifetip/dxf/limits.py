"""Moved to knifetip.intake.limits, where the other readers find it too."""

from knifetip.intake.limits import REACH, Limits

__all__ = ["REACH", "Limits"]
