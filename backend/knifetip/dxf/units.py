"""units: what the header of a DXF says of its unit.

    header variables -> the unit that is stated, and hints of the others

Nothing is judged here: whether it is true is for the room ``units``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.messages import Message
from knifetip.model.unit import Hint

#: $INSUNITS of the units that are read.
_CODES: Final = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m"}

#: $INSUNITS of units in which nobody draws cartons.
_OTHERS: Final = {
    3: "miles",
    7: "kilometres",
    8: "microinches",
    9: "mils",
    10: "yards",
    11: "ångströms",
    12: "nanometres",
    13: "microns",
    14: "decimetres",
    15: "decametres",
    16: "hectometres",
    17: "gigametres",
    18: "astronomical units",
    19: "light years",
    20: "parsecs",
    21: "US survey feet",
    22: "US survey inches",
    23: "US survey yards",
    24: "US survey miles",
}


#: $LUNITS that write lengths as feet and inches.
_INCHES: Final = {"3": "feet and decimal inches", "4": "feet and fractions of inches"}

#: What dimensions are multiplied by to be shown.
_SHOWN: Final = ((25.4, "25.4"), (1.0 / 25.4, "0.03937"), (10.0, "10"), (1000.0, "1000"))


def stated(variables: Mapping[str, str]) -> tuple[str, Message]:
    """Return the unit that header variables state, empty if they do not, and the evidence."""
    written = variables.get("$INSUNITS")
    if written is None:
        return "", Message("unit.header-missing")
    try:
        code = int(float(written))
    except (ValueError, OverflowError):
        return "", Message("unit.header-not-a-number", value=written[:20])
    if code in _CODES:
        return _CODES[code], Message("unit.header", value=code)
    if code == 0:
        return "", Message("unit.header-unitless")
    if code in _OTHERS:
        return "", Message("unit.header-unsupported", value=code, name=_OTHERS[code])
    return "", Message("unit.header-undefined", value=code)


def hints(variables: Mapping[str, str]) -> tuple[Hint, ...]:
    """Return what other header variables have to do with the unit."""
    found = []
    measurement = variables.get("$MEASUREMENT", "")
    if measurement in ("0", "1"):
        says = "metric" if measurement == "1" else "imperial"
        found.append(Hint(says, f"$MEASUREMENT = {measurement}"))
    notation = _INCHES.get(variables.get("$LUNITS", ""))
    if notation:
        found.append(Hint("inches", f"$LUNITS = {variables['$LUNITS']}: {notation}"))
    shown = ["$DIMLFAC"] + ["$DIMALTF"] * (variables.get("$DIMALT", "") == "1")
    for name in shown:
        try:
            times = float(variables.get(name, "1"))
        except ValueError:
            continue
        for factor, said in _SHOWN:
            if abs(times - factor) < 1e-3 * factor:
                found.append(Hint(f"shown × {said}", f"{name} = {times:g}"))
    return tuple(found)
