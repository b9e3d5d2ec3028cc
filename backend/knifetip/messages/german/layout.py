"""layout: German texts of the messages of ``catalogue.layout``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "layout.changed": Text(
        "Layout geändert; Zahl der Exemplare auf dem Bogen: {count}",
    ),
    "layout.drawing-changed": Text(
        "Zeichnung {drawing} hat Revision {current}; das Layout wurde mit Revision {revision} "
        "erstellt",
        "Die geänderte Zeichnung auf dem Bogen ansehen und das Layout mit ihrer neuen Revision "
        "speichern.",
    ),
    "layout.edge-elsewhere": Text(
        "eine Kante von Exemplar {copy} liegt {distance:.4g} mm neben der Stelle, an der das "
        "Layout sie platziert",
    ),
    "layout.edges-added": Text(
        "Kanten auf dem Bogen, die zu keiner Zeichnung gehören: {count}",
    ),
    "layout.edges-missing": Text(
        "auf dem Bogen fehlen Kanten von Exemplar {copy}",
    ),
    "layout.no-unit": Text(
        "die Einheit der Zeichnung {drawing} ist nicht bekannt, also auch nicht ihre Größe auf "
        "dem Bogen",
        "Die Einheit der Zeichnung wählen.",
    ),
    "layout.of-layout": Text(
        "{drawing} ist ein Layout, und ein Layout kann nicht auf einem anderen Bogen platziert "
        "werden",
        "Die Zeichnungen des Layouts platzieren.",
    ),
    "layout.off-sheet": Text(
        "Exemplar {copy} ragt {distance:.4g} mm über den Rand des Bogens",
        "Das Exemplar verschieben oder drehen, oder einen größeren Bogen verwenden.",
    ),
    "layout.overlap": Text(
        "die Exemplare {copy} und {other} überlappen sich um {area:.4g} mm²",
        "Eines der beiden verschieben.",
    ),
    "layout.read-only": Text(
        "die Linien des Layouts {layout} sind die seiner Zeichnungen und können im Layout nicht "
        "geändert werden",
        "Die Zeichnung ändern und das Layout mit ihrer neuen Revision speichern.",
    ),
    "layout.sheet-fixed": Text(
        "das Layout {layout} legt seinen Bogen fest, und der Auftrag nennt einen anderen",
        "Den Bogen im Auftrag weglassen oder den Bogen des Layouts ändern.",
    ),
    "layout.too-many-edges": Text(
        "die Exemplare auf dem Bogen haben zusammen mehr als {limit} Kanten",
        "Weniger Exemplare platzieren, oder mehrere Bögen verwenden.",
    ),
}
