"""units: what the header of a DXF says of its unit.

    header variables -> the unit that is stated, and hints of the others

Nothing is judged here: whether it is true is for the room ``units``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

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


def stated(variables: Mapping[str, str]) -> tuple[str, str]:
    """Return the unit that header variables state, empty if they do not, and the evidence."""
    written = variables.get("$INSUNITS")
    if written is None:
        return "", "the file has no $INSUNITS"
    try:
        code = int(float(written))
    except (ValueError, OverflowError):
        return "", f"$INSUNITS = {written[:20]!r} is no number"
    if code in _CODES:
        return _CODES[code], f"$INSUNITS = {code}"
    if code == 0:
        return "", "$INSUNITS = 0: the file says that it has no unit"
    if code in _OTHERS:
        return "", f"$INSUNITS = {code}: {_OTHERS[code]}, which are not read"
    return "", f"$INSUNITS = {code} has no meaning"


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
