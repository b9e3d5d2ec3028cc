"""The file formats that drawings are read from: how each is detected, named and read."""

from __future__ import annotations

from knifetip.formats.registry import FORMATS, Format, format_of, read_file

__all__ = ["FORMATS", "Format", "format_of", "read_file"]
