"""Import formats: detection by content, and the table of formats with their readers."""

from __future__ import annotations

from knifetip.formats.opening import OpenFile, choose_page, open_file, read_each_page
from knifetip.formats.registry import FORMATS, Format, format_of

__all__ = [
    "FORMATS",
    "Format",
    "OpenFile",
    "choose_page",
    "format_of",
    "open_file",
    "read_each_page",
]
