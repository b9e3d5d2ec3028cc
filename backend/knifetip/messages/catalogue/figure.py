"""figure: titles of the figures of a verdict, and how commands print them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "figure.bottom-uncut": entry(
        "Uncut on bottom face",
    ),
    "figure.in-mm": entry(
        "{title}: {value:.2f} mm",
        title="message",
        value="number",
    ),
    "figure.in-seconds": entry(
        "{title}: {value:.1f} s",
        title="message",
        value="number",
    ),
    "figure.lowest-travel": entry(
        "Lowest travel above the board",
    ),
    "figure.mat-depth": entry(
        "Deepest cut into the mat",
    ),
    "figure.number": entry(
        "{title}: {value:.0f}",
        title="message",
        value="number",
    ),
    "figure.slit-length": entry(
        "Slit as wide as the tool",
    ),
    "figure.top-overcut": entry(
        "Overcut on top face",
    ),
}
