"""Conversion of files by other programs, which are optional and run as child processes."""

from __future__ import annotations

from knifetip.formats.conversion.converter import Conversion, Converter
from knifetip.formats.conversion.ghostscript import GHOSTSCRIPT
from knifetip.formats.conversion.libredwg import LIBREDWG

__all__ = ["GHOSTSCRIPT", "LIBREDWG", "Conversion", "Converter"]
