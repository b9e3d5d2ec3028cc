"""unit: the unit of length of a drawing: its evidence and warnings."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "unit.given": entry("given"),
    "unit.header": entry("$INSUNITS = {value}", value="count"),
    "unit.header-missing": entry("the file has no $INSUNITS"),
    "unit.header-not-a-number": entry("$INSUNITS = {value!r} is not a number", value="text"),
    "unit.header-undefined": entry("$INSUNITS = {value} has no meaning", value="count"),
    "unit.header-unitless": entry("$INSUNITS = 0: the file states that it has no unit"),
    "unit.header-unsupported": entry(
        "$INSUNITS = {value}: {name}, which are not supported",
        value="count",
        name="text",
    ),
    "unit.in-file": entry("{statement}", statement="text"),
    "unit.inconclusive": entry(
        "{stated}; the drawing does not give enough evidence for {unit:unit}",
        stated="message",
        unit="text",
    ),
    "unit.not-given": entry("the unit is not known"),
    "unit.overruled": entry(
        "{stated}; the drawing supports {unit:unit}: {reason}",
        stated="message",
        unit="text",
        reason="text",
    ),
    "unit.unsupported": entry(
        "{unit!r} is not a supported unit of length.",
        "Choose one of {known:, }.",
        unit="text",
        known="texts",
    ),
}
