"""Moved to knifetip.intake.sheet, where the other readers find it too."""

from knifetip.intake.sheet import Sheet

__all__ = ["Sheet"]
