"""Moved to knifetip.intake.assemble, where the other readers find it too."""

from knifetip.intake.assemble import Known, assemble

__all__ = ["Known", "assemble"]
