"""dry_run: German texts of the messages of ``catalogue.dry_run``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "dry-run.in-progress": Text(
        "Die Maschine fährt für Auftrag {job} über dem Karton. Der Auftrag wurde nicht gestartet.",
        "Warten, bis die Fahrt beendet ist, oder sie stoppen. Dann den Auftrag starten.",
    ),
    "dry-run.no-job": Text(
        "Kein Auftrag wartet an dieser Maschine auf seinen Start, also gibt es nichts, was über "
        "dem Karton zu fahren wäre.",
        "Einen Auftrag für diese Maschine freigeben und die Fahrt vor seinem Start anfordern.",
    ),
    "dry-run.no-lift": Text(
        "Zeile {line} des Probeprogramms ist kein Abheben senkrecht auf Z {height:g}. Nichts "
        "wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.no-work": Text(
        "Das Programm des Auftrags arbeitet nicht im Karton, hat also keinen Rahmen.",
        "Den Auftrag öffnen und sein Programm prüfen.",
    ),
    "dry-run.not-running": Text(
        "Die Maschine fährt kein Programm über dem Karton, also gibt es nichts anzuhalten oder "
        "fortzusetzen.",
    ),
    "dry-run.other-path": Text(
        "Zeile {line} des Probeprogramms verlässt die Bahn des Programms. Nichts wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.switches": Text(
        "Zeile {line} des Probeprogramms schaltet etwas ein. Nichts wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.too-low": Text(
        "Zeile {line} des Probeprogramms fährt Z auf {z:g}, unter {height:g}. Nichts wurde "
        "gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.unknown-line": Text(
        "Zeile {line} des Programms kann nicht über dem Karton gefahren werden: „{text}“. Nichts "
        "wurde gesendet.",
        "Den Auftrag neu berechnen lassen. Ein von Hand geändertes Programm kann nicht zur Probe "
        "gefahren werden.",
    ),
    "dry-run.uses-machine": Text(
        "Die Maschine fährt ein Programm über dem Karton.",
        "Warten, bis die Fahrt beendet ist, oder sie zuerst stoppen.",
    ),
    "tool-check.in-zone": Text(
        "Der Punkt liegt in der Sperrzone {zone} oder so nahe, dass das Werkzeug sie berühren "
        "würde. Nichts hat sich bewegt.",
        "Einen anderen Punkt wählen.",
    ),
    "tool-check.large-shift": Text(
        "Die Korrektur einer Station bei einer Werkzeugprüfung beträgt höchstens {largest:g} mm "
        "oder Grad.",
        "Den Versatz der Station neu messen und in der Maschinendatei ändern.",
    ),
    "tool-check.not-lowered": Text(
        "Das Werkzeug ist über dem Punkt, wurde aber nicht gesenkt: Z müsste auf {target:.1f} "
        "fahren, und sein Verfahrweg endet bei {lowest:g}.",
        "Das Werkzeug von oben prüfen und das Z der Station in der Maschinendatei.",
    ),
    "tool-check.not-reached": Text(
        "Z ist nicht rechtzeitig bei {target:.1f} zum Stehen gekommen. Das Werkzeug wurde wieder "
        "gehoben.",
        "Die Maschine prüfen, dann noch einmal versuchen.",
    ),
    "tool-check.not-lowered-beam": Text(
        "Der Laser ist über dem Punkt, wurde aber nicht gesenkt oder eingeschaltet.",
        "Seine Position mit dem Zeigelaser prüfen, wenn er einen hat.",
    ),
}
