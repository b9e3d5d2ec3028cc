"""registry: all wizards by their codes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.errors import LibraryError
from knifetip.testpieces import (
    crease_depth,
    deflection,
    knife_depth,
    squareness,
    station_offset,
    v_cutter,
)
from knifetip.testpieces.wizard import Wizard

_WIZARDS: Final = (
    v_cutter.WIZARD,
    knife_depth.WIZARD,
    crease_depth.WIZARD,
    station_offset.WIZARD,
    deflection.WIZARD,
    squareness.WIZARD,
)

#: Every wizard by its code, in the order of lists.
WIZARDS: Final[Mapping[str, Wizard]] = {wizard.code: wizard for wizard in _WIZARDS}


def wizard_of(code: str) -> Wizard:
    """Return the wizard with a code; raise ``LibraryError`` if there is none."""
    try:
        return WIZARDS[code]
    except KeyError:
        raise LibraryError(
            "library.unknown", shelf="testpiece", name=code[:80], known=sorted(WIZARDS)
        ) from None
