"""units: what a file says of its unit, and a drawing in another one.

    $INSUNITS -> unit and evidence        Drawing, unit -> Drawing in mm

Nothing is guessed: a drawing whose file is silent stays in file units and asks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from knifetip.errors import UnitUnknown
from knifetip.model.drawing import Drawing
from knifetip.model.question import Question

#: Millimetres to one unit.
MILLIMETRES: Final[dict[str, float]] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}

_NAMES: Final = {"mm": "mm", "cm": "cm", "m": "metres", "in": "inches", "ft": "feet"}

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

#: A drawing whose longer side is within this could be a carton (mm).
_PLAUSIBLE: Final = (20.0, 5000.0)


def factor(unit: str) -> float:
    """Return the millimetres to one unit; 1 for the empty unit, that of the file.

    Raises
    ------
    UnitUnknown
        There is no such unit.
    """
    if unit == "":
        return 1.0
    try:
        return MILLIMETRES[unit]
    except KeyError:
        raise UnitUnknown(
            f"{unit!r} is not a unit of length that is read.",
            f"Say one of {', '.join(MILLIMETRES)}.",
        ) from None


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


def rescaled(drawing: Drawing, unit: str) -> Drawing:
    """Return a drawing whose file units are these: the first time, or corrected.

    Bulges, layers and the ledger's rows stay as they are.  Ellipses and splines were fitted when
    the drawing was read and are scaled with all the rest: from mm to a larger unit their deviation
    grows too, and reading the bytes again with ``unit`` fits them anew.

    Parameters
    ----------
    unit
        "mm", "cm", "m", "in" or "ft"; "" takes the unit away, back to file units.

    Raises
    ------
    UnitUnknown
        There is no such unit.
    """
    old, new = factor(drawing.unit), factor(unit)
    ledger = replace(drawing.ledger, length=drawing.ledger.length / old * new)
    return replace(
        drawing,
        # Divided first: what is in mm loses no bit on the way to file units and back.
        ends=drawing.ends / old * new,
        ledger=ledger,
        inscriptions=tuple(words.scaled(old, new) for words in drawing.inscriptions),
        unit=unit,
        evidence="given" if unit else "nobody has said the unit",
    )


def question(drawing: Drawing) -> Question | None:
    """Return what must be asked about the unit, None where it is known."""
    if drawing.unit:
        return None
    low_x, low_y, high_x, high_y = drawing.bounds
    width, height = high_x - low_x, high_y - low_y
    longer = max(width, height)
    likely = [
        unit
        for unit, scale in MILLIMETRES.items()
        if _PLAUSIBLE[0] <= longer * scale <= _PLAUSIBLE[1]
    ]
    sizes = [
        f"as {_NAMES[unit]} {'the drawing is ' * (place == 0)}"
        f"{_measure(width * MILLIMETRES[unit])} × {_measure(height * MILLIMETRES[unit])} mm"
        for place, unit in enumerate(likely or MILLIMETRES)
    ]
    text = ", ".join(sizes)
    if drawing.evidence.startswith("$INSUNITS = 0") or "no $INSUNITS" in drawing.evidence:
        why = "The file does not say its unit."
    else:
        why = f"The file does not say a unit that is read ({drawing.evidence})."
    return Question("unit", f"{why} {text[0].upper()}{text[1:]}.", tuple(MILLIMETRES))


def _measure(size: float) -> str:
    return f"{size:.1f}" if abs(size) < 1000.0 else f"{size:.0f}"
