"""queue: German texts of the messages of ``catalogue.queue``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "queue.changed": Text(
        "Die Warteschlange von {machine} hat sich geändert, seit sie angezeigt wurde. Der Auftrag "
        "wurde nicht verschoben.",
        "Die neue Reihenfolge der Warteschlange prüfen und den Auftrag bei Bedarf noch einmal "
        "verschieben.",
    ),
    "queue.claimed": Text(
        "Die Maschine {machine} hat Auftrag {job} aus der Warteschlange genommen, also sind sein "
        "Platz und seine Exemplare nicht mehr zu ändern.",
        "Ist der Auftrag noch nicht bestätigt, ihn zurückstellen: Er kommt dann wieder in die "
        "Warteschlange.",
    ),
    "queue.copies-changed": Text(
        "Der Bediener hat die Anzahl der Exemplare von {former} auf {copies} geändert.",
    ),
    "queue.copies-done": Text(
        "Von Auftrag {job} {done:ist # Exemplar|sind # Exemplare} fertig, also muss die Anzahl "
        "größer sein.",
        "Eine Zahl größer als {done} eingeben oder den Auftrag abbrechen.",
    ),
    "queue.does-not-fit": Text(
        "Auftrag {job} wurde nicht zu {machine} verschoben. {reason}",
        "{reason:hint}",
    ),
    "queue.let-go": Text(
        "Der Bediener hat die Zurückstellung des Auftrags in der Warteschlange aufgehoben.",
    ),
    "queue.moved-after": Text(
        "Der Bediener hat den Auftrag an das Ende der Warteschlange verschoben, hinter Auftrag "
        "{after}.",
    ),
    "queue.moved-before": Text(
        "Der Bediener hat den Auftrag an die Spitze der Warteschlange verschoben, vor Auftrag "
        "{before}.",
    ),
    "queue.moved-between": Text(
        "Der Bediener hat den Auftrag in der Warteschlange verschoben: zwischen Auftrag {after} "
        "und Auftrag {before}.",
    ),
    "queue.no-neighbour": Text(
        "Auftrag {job} kann nicht neben Auftrag {neighbour} verschoben werden, der nicht auf "
        "{machine} wartet.",
        "Die jetzige Warteschlange ansehen. Aufträge nennen, die auf die Maschine warten und "
        "nicht übernommen sind.",
    ),
    "queue.not-waiting": Text(
        "Auftrag {job} ist {state:state} und wartet nicht, kann also in der Warteschlange nicht "
        "geändert werden.",
        "{advice}",
    ),
    "queue.priority-changed": Text(
        "Die Priorität des Auftrags wurde von {former} auf {priority} geändert.",
    ),
    "queue.put-on-hold": Text(
        "Der Bediener hat den Auftrag in der Warteschlange zurückgestellt.",
    ),
    "queue.transferred": Text(
        "Der Bediener hat den Auftrag von {former} zu {machine} verschoben. Sein Programm wurde "
        "neu berechnet.",
    ),
    "tool-life.near": Text(
        "Das Werkzeug {name} in Station {station} hat {used:.0f} m Linien bearbeitet, "
        "{percent:.0f} % seiner Standzeit von {life:.0f} m.",
        "Ein neues Werkzeug bereithalten. Den Wechsel des Werkzeugs auf der Seite der Maschine "
        "eintragen.",
    ),
    "tool-life.no-station": Text(
        "Die Maschine {machine} hat keine Station {station}.",
        "Die Nummer einer Station aus der Liste der Werkzeuge der Maschine verwenden.",
    ),
    "tool-life.over": Text(
        "Das Werkzeug {name} in Station {station} hat {used:.0f} m Linien bearbeitet, "
        "{percent:.0f} % seiner Standzeit von {life:.0f} m.",
        "Das Werkzeug wechseln und den Wechsel eintragen, oder das Werkzeug prüfen und beim "
        "Bestätigen des Auftrags angeben, warum es im Einsatz bleibt.",
    ),
}
