"""mcx314: messages about toolpaths that the motion chip MCX314 cannot execute."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "mcx314.four-axes": entry(
        "Row {row} of the toolpath moves four axes at once, and the chip MCX314 can move three.",
        "Let the tool turn before or after its depth changes.",
        row="count",
    ),
    "mcx314.speed": entry(
        "Row {row} of the toolpath needs {rate:.0f} pulses per second, and the chip MCX314 "
        "makes {slowest} to {fastest}.",
        "Choose another feed for the tool, or another multiple of the drive speed.",
        row="count",
        rate="number",
        slowest="count",
        fastest="count",
    ),
    "mcx314.too-far": entry(
        "Row {row} of the toolpath needs {pulses} pulses, and the chip MCX314 counts at most "
        "{limit} in one segment.",
        "Divide the edge, or use fewer pulses per millimetre.",
        row="count",
        pulses="count",
        limit="count",
    ),
    "mcx314.too-short": entry(
        "Row {row} of the toolpath takes {milliseconds:.3g} ms, and writing the next segment to "
        "the chip MCX314 takes up to {refill:.3g} ms.",
        "Choose a slower feed for the tool, or remove short edges from the drawing.",
        row="count",
        milliseconds="number",
        refill="number",
    ),
    "mcx314.underrun": entry(
        "The chip MCX314 came to rest before segment {segment} was written, in the middle of a "
        "cut.",
        "Choose a slower feed. Check the board and the position of the machine first.",
        segment="count",
    ),
}
