"""folding: German texts of the messages of ``catalogue.folding``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "folding.angle-invalid": Text(
        "{value} ist kein Winkel einer Faltung",
        "Die Nummer der Faltung, einen Doppelpunkt und den Winkel in Grad von -180 bis 180 "
        "schreiben, etwa 3:45.",
    ),
    "folding.collision": Text(
        "die Felder {panel} und {other} durchdringen sich um {distance:.4g} mm",
        "Die Winkel ihrer Faltungen oder die Größe eines Feldes ändern.",
    ),
    "folding.flap-too-long": Text(
        "Feld {panel} ragt {distance:.4g} mm über Feld {other} hinaus",
        "Die Klappe kürzen.",
    ),
    "folding.flaps-overlap": Text(
        "die Felder {panel} und {other} zeigen aufeinander und überlappen sich um {distance:.4g} "
        "mm",
        "Sie kürzen, falls sie sich ohne Überlappung treffen sollen.",
    ),
    "folding.gap": Text(
        "die Faltung zwischen den Feldern {panel} und {other} bleibt um {distance:.4g} mm offen",
        "Die Winkel der Faltungen ringsum ändern.",
    ),
    "folding.groove-narrow": Text(
        "die Nut zwischen den Feldern {panel} und {other} schließt bei {angle:.4g}°, gefaltet wird "
        "um {required:.4g}°",
        "Die Nut mit einem V-Messer mit größerem Winkel schneiden oder um weniger falten.",
    ),
    "folding.no-such-fold": Text(
        "die Faltung {fold} gibt es nicht; Zahl der Faltungen der Zeichnung: {count}",
    ),
    "folding.not-straight": Text(
        "die Faltung zwischen den Feldern {panel} und {other} ist nicht gerade und wird deshalb "
        "flach gezeigt",
    ),
    "folding.solids-collide": Text(
        "die Felder {panel} und {other} liegen um {distance:.4g} mm ineinander, mehr als der "
        "{caliper:.4g} mm dicke Karton nachgibt",
        "Ein Feld um die Differenz kürzen oder seine Faltung verschieben.",
    ),
    "folding.too-many-edges": Text(
        "die Zeichnung hat mehr als {limit} Kanten von Schnitten und Faltungen, zu viele zum "
        "Falten",
        "Eine Zeichnung mit einem Zuschnitt falten.",
    ),
    "folding.too-many-panels": Text(
        "die Zeichnung hat mehr als {limit} Felder, zu viele zum Falten",
        "Eine Zeichnung mit einem Zuschnitt falten.",
    ),
}
