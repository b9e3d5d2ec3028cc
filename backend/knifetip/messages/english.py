"""english: the English texts and hints of all messages, and the names of units and tools.

The module has four tables: ``UNITS``, ``TOOLS``, ``TEXTS`` and ``HINTS``.  Each further language
needs a module with the same tables.  ``messages.render`` describes the templates.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.messages.catalogue import MESSAGES

#: Names of the units of length in a sentence; the empty unit is the unit of the file.
UNITS: Final[Mapping[str, str]] = {
    "": "units of the file",
    "mm": "mm",
    "cm": "cm",
    "m": "metres",
    "in": "inches",
    "ft": "feet",
    "pt": "points",
    "px": "pixels",
    "px-90": "pixels of 1/90 inch",
    "mi": "miles",
    "km": "kilometres",
    "uin": "microinches",
    "mil": "mils",
    "yd": "yards",
    "angstrom": "ångströms",
    "nm": "nanometres",
    "um": "micrometres",
    "dm": "decimetres",
    "dam": "decametres",
    "hm": "hectometres",
    "Gm": "gigametres",
    "au": "astronomical units",
    "ly": "light years",
    "pc": "parsecs",
    "survey-ft": "US survey feet",
    "survey-in": "US survey inches",
    "survey-yd": "US survey yards",
    "survey-mi": "US survey miles",
}

#: Names of the tools in findings.
TOOLS: Final[Mapping[str, str]] = {
    "cutter": "cutter",
    "knife": "knife",
    "v-cutter": "V-cutter",
    "wheel": "creasing wheel",
}

#: Text of each message: what is wrong, and where.
TEXTS: Final[Mapping[str, str]] = {code: found.text for code, found in MESSAGES.items()}

#: Hint of each message that has one: what the user can do.
HINTS: Final[Mapping[str, str]] = {
    code: found.hint for code, found in MESSAGES.items() if found.hint
}
