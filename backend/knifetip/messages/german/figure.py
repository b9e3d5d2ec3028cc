"""figure: German texts of the messages of ``catalogue.figure``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "figure.bottom-uncut": Text(
        "Ungeschnitten an der Unterseite",
    ),
    "figure.in-mm": Text(
        "{title}: {value:.2f} mm",
    ),
    "figure.in-seconds": Text(
        "{title}: {value:.1f} s",
    ),
    "figure.lowest-travel": Text(
        "Niedrigste Fahrt über dem Karton",
    ),
    "figure.mat-depth": Text(
        "Tiefster Schnitt in die Matte",
    ),
    "figure.number": Text(
        "{title}: {value:.0f}",
    ),
    "figure.slit-length": Text(
        "Schlitz so breit wie das Werkzeug",
    ),
    "figure.top-overcut": Text(
        "Überschnitt an der Oberseite",
    ),
}
