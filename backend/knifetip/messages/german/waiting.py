"""waiting: German texts of the messages of ``catalogue.waiting``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "waiting.check-refused": Text(
        "{machine} hat das Programm nicht begonnen: Keine Zeile davon wurde ausgeführt. {reason}",
        "{reason:hint} Dann noch einmal versuchen, den Auftrag neu berechnen oder abbrechen. "
        "Andere Aufträge der Warteschlange laufen weiter.",
    ),
    "waiting.confirmed": Text(
        "Der Bediener hat den Auftrag bestätigt, und {machine} startet.",
    ),
    "waiting.for-controller": Text(
        "Der Auftrag wartet, weil das Gateway von {machine} (das Programm, das Aufträge an die "
        "Maschine sendet) nicht mit der Steuerung der Maschine verbunden ist.",
        "Die Steuerung einschalten und ihr Kabel prüfen.",
    ),
    "waiting.controller-not-connected": Text(
        "Der Auftrag wartet, weil das Gateway von {machine} nicht mit der Steuerung der Maschine "
        "verbunden ist. {reason}",
        "{reason:hint}",
    ),
    "waiting.obstacle": Text(
        "Der Auftrag wartet, weil {machine} jetzt keinen Auftrag annimmt. {reason}",
        "{reason:hint}",
    ),
    "waiting.for-end": Text(
        "Das ganze Programm wurde an {machine} gesendet, die nicht meldet, wann sie fertig ist.",
        "Wenn die Maschine fertig ist und steht, dies auf der Seite der Station oder mit knifetip "
        "job end bestätigen: Das Exemplar ist dann fertig. Hat die Maschine das Programm nicht "
        "beendet, den Auftrag abbrechen.",
    ),
    "waiting.for-gateway": Text(
        "Der Auftrag wartet, weil das Gateway von {machine} (das Programm, das Aufträge an die "
        "Maschine sendet) nicht mit dem Server verbunden ist.",
        "Die Maschine einschalten und ihr Gateway starten.",
    ),
    "waiting.for-machine": Text(
        "Der Auftrag wartet, bis das Gateway von {machine} (das Programm, das Aufträge an die "
        "Maschine sendet) ihn aus der Warteschlange nimmt.",
    ),
    "waiting.for-person": Text(
        "Der Auftrag wartet, weil das Gateway von {machine} (das Programm, das Aufträge an die "
        "Maschine sendet) nicht mit dem Server verbunden ist.",
        "{advice}",
    ),
    "waiting.for-sheet": Text(
        "Exemplar {copy} von {copies} des Auftrags ist fertig. Das nächste Exemplar braucht einen "
        "neuen Bogen.",
        "Einen neuen Bogen {board} auf den Tisch legen, dann den neuen Bogen bestätigen. Die "
        "Maschine beginnt danach mit dem nächsten Exemplar. {sheet}",
    ),
    "waiting.for-rest": Text(
        "Der Auftrag wartet, bis der Bediener von {machine} bestätigt, dass der Bogen von Auftrag "
        "{job}, dessen Rest er macht, noch an seinem Platz liegt. Benötigt: Material „{board}“. "
        "{details: }",
        "Prüfen, ob der Bogen unbewegt und alle Werkzeuge heil sind, dann den Auftrag bestätigen, "
        "um ihn zu starten. Ist der Bogen bewegt oder weg, den Auftrag abbrechen.",
    ),
    "waiting.for-start": Text(
        "Der Auftrag wartet, bis der Bediener von {machine} bestätigt, dass der Tisch frei ist. "
        "Benötigt: Material „{board}“. {details: }",
        "Den Tisch prüfen, dann den Auftrag bestätigen, um ihn zu starten.",
    ),
    "waiting.for-turn": Text(
        "Der Auftrag wartet, bis {machine} die Aufträge beendet hat, die in der Warteschlange vor "
        "ihm kommen.",
    ),
    "waiting.on-hold": Text(
        "Der Auftrag ist in der Warteschlange von {machine} zurückgestellt. Andere Aufträge "
        "kommen vor ihm an die Reihe.",
        "Die Zurückstellung aufheben, damit die Maschine den Auftrag nimmt.",
    ),
    "waiting.taken": Text(
        "Der Auftrag wartet, weil {machine} mit Auftrag {job} belegt ist ({state:state}).",
    ),
    "waiting.taken-interrupted": Text(
        "Der Auftrag wartet, weil {machine} mit Auftrag {job} belegt ist, der unterbrochen ist.",
        "Zuerst jenen Auftrag als fertig melden, noch einmal einreihen oder verwerfen.",
    ),
    "waiting.taken-unconfirmed": Text(
        "Der Auftrag wartet, weil {machine} mit Auftrag {job} belegt ist, der auf seine "
        "Bestätigung wartet.",
        "Jenen Auftrag bestätigen oder abbrechen.",
    ),
    "waiting.outdated": Text(
        "Das Programm des Auftrags ist veraltet: {changes:; }.",
        "Den Auftrag neu berechnen. Sein Programm wird dann für die jetzige Maschine und das "
        "jetzige Material gemacht und geprüft.",
    ),
    "waiting.sheet-outline": Text(
        "Der Bogen muss auf die Außenkontur der Zeichnung zugeschnitten sein.",
    ),
    "waiting.sheet-size": Text(
        "Der Bogen muss auf {width:g} × {height:g} mm zugeschnitten sein.",
    ),
    "waiting.tool": Text(
        "{name} (Station {station})",
    ),
    "waiting.tools": Text(
        "Werkzeuge: {tools:, }.",
    ),
    "waiting.unfinished-sheet": Text(
        "Der unfertige Bogen von Auftrag {job} liegt vielleicht noch darauf.",
    ),
    "waiting.unconfirmed-run": Text(
        "{machine} wurde gestartet, aber der Bediener hat nicht bestätigt, dass der Tisch frei "
        "ist. Benötigt: Material „{board}“. {details: }",
        "Den Tisch prüfen. Den Auftrag bestätigen, damit er weiterläuft, oder ihn abbrechen.",
    ),
}
