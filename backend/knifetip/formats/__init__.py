"""Import formats: detection by content, and the table of formats with their readers."""

from __future__ import annotations

from knifetip.formats.registry import FORMATS, Format, format_of, read_file

__all__ = ["FORMATS", "Format", "format_of", "read_file"]
