"""obstacle: German texts of the messages of ``catalogue.obstacle``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "obstacle.asleep": Text(
        "{name} ist im Ruhezustand.",
        "Den Tisch prüfen, dann „Freigeben“ drücken, um die Steuerung zu wecken. Danach eine "
        "Referenzfahrt machen.",
    ),
    "obstacle.busy": Text(
        "{name} führt etwas aus, das zu keinem Auftrag gehört.",
        "Warten, bis die Maschine steht. Bleibt es so, „Freigeben“ drücken: Die Maschine hält an "
        "und bewegt keine Achse.",
    ),
    "obstacle.check-mode": Text(
        "{name} ist im Prüfbetrieb, in dem sich nichts bewegt.",
        "„Freigeben“ drücken, um den Prüfbetrieb zu beenden.",
    ),
    "obstacle.door-closed": Text(
        "{name} ist angehalten, nachdem die Schutztür geöffnet wurde.",
        "Den Tisch prüfen, dann „Freigeben“ drücken: Die Maschine verwirft, was sie hielt, und "
        "bewegt keine Achse. Danach das Werkzeug heben.",
    ),
    "obstacle.door-open": Text(
        "Die Schutztür von {name} ist offen.",
        "Die Schutztür schließen, dann „Freigeben“ drücken.",
    ),
    "obstacle.held": Text(
        "{name} ist angehalten, und kein Auftrag läuft darauf.",
        "Den Tisch prüfen, dann „Freigeben“ drücken: Die Maschine verwirft, was sie hielt, und "
        "bewegt keine Achse. Danach das Werkzeug heben.",
    ),
    "obstacle.job-door-closed": Text(
        "Der Auftrag auf {name} ist angehalten, weil die Schutztür geöffnet wurde.",
        "Den Tisch prüfen, dann „Weiter“ drücken, um an dieser Stelle fortzusetzen, oder „Stopp“, "
        "um den Auftrag zu beenden.",
    ),
    "obstacle.job-door-open": Text(
        "Der Auftrag auf {name} ist angehalten, weil die Schutztür offen ist.",
        "Die Schutztür schließen, dann „Weiter“ drücken, um an dieser Stelle fortzusetzen, oder "
        "„Stopp“, um den Auftrag zu beenden.",
    ),
    "obstacle.limit-pressed": Text(
        "Ein Endschalter von {name} ist noch gedrückt ({axes:, }).",
        "Diese Achsen von ihren Schaltern wegfahren, bis dieser Text verschwindet, oder eine "
        "Referenzfahrt machen. Steht keine Achse an einem Schalter, den Schalter und sein Kabel "
        "prüfen.",
    ),
    "obstacle.limit-unused": Text(
        "Ein Endschalter von {name} ist gedrückt ({axes:, }). Er hält die Maschine nicht an, weil "
        "die Endschalter in der Steuerung ausgeschaltet sind.",
        "Diese Achsen von ihren Schaltern wegfahren. Steht keine Achse an einem Schalter, den "
        "Schalter und sein Kabel prüfen.",
    ),
    "obstacle.moves": Text(
        "{name} bewegt sich, aber nicht für einen Auftrag.",
        "Warten, bis die Maschine steht, oder „Freigeben“ drücken: Die Maschine hält an und "
        "verwirft den Rest.",
    ),
    "obstacle.tool-change": Text(
        "{name} wartet auf einen Werkzeugwechsel, und kein Auftrag läuft darauf.",
        "Prüfen, dass das Werkzeug fest sitzt, dann „Freigeben“ drücken: Die Maschine verwirft "
        "den Rest und bewegt keine Achse.",
    ),
}
