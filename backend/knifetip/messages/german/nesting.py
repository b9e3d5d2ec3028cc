"""nesting: German texts of the messages of ``catalogue.nesting``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "nesting.failed": Text(
        "die Schachtelung ist wegen eines internen Fehlers fehlgeschlagen; die bisher beste "
        "Anordnung bleibt erhalten",
        "Die Schachtelung wiederholen. Wenn sie wieder fehlschlägt, das Protokoll des Servers an "
        "die Entwickler senden.",
    ),
    "nesting.no-room": Text(
        "die Ränder lassen auf dem Bogen von {width:.6g} × {height:.6g} mm keinen Platz",
        "Die Ränder verkleinern, oder einen größeren Bogen verwenden.",
    ),
    "nesting.of-another": Text(
        "die Schachtelung {id} gehört einem anderen Benutzer",
        "Den Benutzer fragen, der sie begonnen hat, oder einen Bediener.",
    ),
    "nesting.output": Text(
        "die Ausgabedatei {file} hat eine andere Endung als .json und .dxf",
        "Einen Namen wählen, der mit .json oder .dxf endet.",
    ),
    "nesting.result": Text(
        "{file}: Bogen: {sheets}; Nutzung des Materials {use:.4g} %, mit Rechtecken "
        "{rectangles:.4g} %; in Löchern: {in_holes}",
    ),
    "nesting.sheet-size": Text(
        "„{text}“ ist keine Größe eines Bogens",
        "Breite und Höhe in mm schreiben, etwa 1200x800; für Restbogen 600x400x2 für zwei.",
    ),
    "nesting.too-large": Text(
        "Teil {part} von {width:.6g} × {height:.6g} mm passt innerhalb der Ränder auf keinen Bogen",
        "Einen größeren Bogen verwenden, mehr Drehungen erlauben, oder die Ränder verkleinern.",
    ),
    "nesting.too-many-sheets": Text(
        "die Exemplare brauchen mehr als {limit} Bogen",
        "Weniger Exemplare platzieren, oder einen größeren Bogen verwenden.",
    ),
    "nesting.unknown": Text(
        "es gibt keine Schachtelung {id}",
        "Eine neue beginnen; ein Server behält die letzten 500.",
    ),
}
