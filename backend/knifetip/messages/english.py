"""english: the English texts and hints of all messages, and the names of units and tools.

Each further language is a module with such a ``Language``, see ``languages``.
"""

from __future__ import annotations

from typing import Final

from knifetip.messages.catalogue import MESSAGES
from knifetip.messages.language import Language, Names, Text

#: Names of words in arguments; the empty unit is the unit of the file.
NAMES: Final[Names] = {
    "unit": {
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
    },
    "tool": {
        "cutter": "cutter",
        "knife": "knife",
        "v-cutter": "V-cutter",
        "wheel": "creasing wheel",
    },
}

ENGLISH: Final = Language(
    tag="en",
    texts={code: Text(found.text, found.hint) for code, found in MESSAGES.items()},
    names=NAMES,
    conjunction="and",
    alternative="or",
    decimal=".",
    group=",",
)
