"""units: the length unit in the header of a DXF file.

The package ``knifetip.units`` decides whether this unit is plausible.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.drawing_builder.assemble import KnownUnit
from knifetip.dxf.writers import writer_hints
from knifetip.messages import Message
from knifetip.model.unit import UnitHint, factor

#: Names of the supported units, by value of $INSUNITS.
_CODES: Final = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m"}

#: Names of the unsupported units, by value of $INSUNITS.
_OTHERS: Final = {
    3: "mi",
    7: "km",
    8: "uin",
    9: "mil",
    10: "yd",
    11: "angstrom",
    12: "nm",
    13: "um",
    14: "dm",
    15: "dam",
    16: "hm",
    17: "Gm",
    18: "au",
    19: "ly",
    20: "pc",
    21: "survey-ft",
    22: "survey-in",
    23: "survey-yd",
    24: "survey-mi",
}


#: Messages for formats of lengths in inches, by value of $LUNITS.
_INCHES: Final = {"3": "unit.header-decimal-inches", "4": "unit.header-fractions"}

#: Factors by which programs multiply dimensions for display.
_SHOWN: Final = ((25.4, "25.4"), (1.0 / 25.4, "0.03937"), (10.0, "10"), (1000.0, "1000"))


def header_unit(variables: Mapping[str, str]) -> tuple[str, Message]:
    """Return the unit that the header variable $INSUNITS specifies, and a message that explains it.

    The unit is "" if the variable is missing or does not specify a supported unit.
    ``variables`` contains the values of the header variables by name.
    """
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


def hints(variables: Mapping[str, str]) -> tuple[UnitHint, ...]:
    """Return evidence for the unit of a file, from header variables other than $INSUNITS.

    ``variables`` contains the values of the header variables by name.
    """
    evidence = []
    measurement = variables.get("$MEASUREMENT", "")
    if measurement in ("0", "1"):
        kind = "metric" if measurement == "1" else "imperial"
        code = "unit.header-metric" if measurement == "1" else "unit.header-imperial"
        evidence.append(UnitHint(kind, Message(code)))
    if notation := _INCHES.get(variables.get("$LUNITS", "")):
        evidence.append(UnitHint("inches", Message(notation)))
    shown = ["$DIMLFAC"] + ["$DIMALTF"] * (variables.get("$DIMALT", "") == "1")
    for name in shown:
        try:
            times = float(variables.get(name, "1"))
        except ValueError:
            continue
        for ratio, unit in _SHOWN:
            if abs(times - ratio) < 1e-3 * ratio:
                message = Message("unit.header-factor", variable=name, factor=times)
                evidence.append(UnitHint(f"shown × {unit}", message))
    return tuple(evidence)


def known_unit(unit: str, data: bytes, variables: Mapping[str, str]) -> KnownUnit:
    """Return ``unit`` if it is not empty, otherwise the unit that the header variables specify.

    ``data`` is the content of the file, and ``variables`` contains the first values of its header
    variables by name.
    """
    written, evidence = header_unit(variables)
    other = (*writer_hints(data, variables), *hints(variables))
    if unit:
        return KnownUnit(factor(unit), unit, Message("unit.given"), written, other)
    scale = factor(written) if written else 0.0
    return KnownUnit(scale, written, evidence, written, other)
