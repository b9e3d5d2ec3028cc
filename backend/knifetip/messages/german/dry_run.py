"""dry_run: German texts of the messages of ``catalogue.dry_run``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "dry-run.in-progress": Text(
        "Die Maschine macht einen Probelauf von Auftrag {job} über dem Karton, also wurde der "
        "Auftrag nicht gestartet.",
        "Warten, bis der Probelauf beendet ist, oder ihn stoppen. Dann den Auftrag starten.",
    ),
    "dry-run.no-job": Text(
        "Kein Auftrag wartet an dieser Maschine auf seinen Start, also gibt es kein Programm für "
        "einen Probelauf über dem Karton.",
        "Einen Auftrag für diese Maschine freigeben und den Probelauf vor seinem Start anfordern.",
    ),
    "dry-run.no-lift": Text(
        "Interner Fehler: Zeile {line} des Probelaufs muss das Werkzeug senkrecht auf Z {height:g} "
        "heben, macht aber etwas anderes. Nichts wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.no-work": Text(
        "Das Programm des Auftrags berührt den Karton nicht, also gibt es keinen Rahmen "
        "abzufahren.",
        "Den Auftrag öffnen und sein Programm prüfen.",
    ),
    "dry-run.not-running": Text(
        "Die Maschine macht keinen Probelauf, also gibt es nichts anzuhalten oder fortzusetzen.",
    ),
    "dry-run.other-path": Text(
        "Interner Fehler: Zeile {line} des Probelaufs verlässt die Bahn des Programms. Nichts "
        "wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.switches": Text(
        "Interner Fehler: Zeile {line} des Probelaufs schaltet einen Ausgang oder die Spindel ein. "
        "Nichts wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.too-low": Text(
        "Interner Fehler: Zeile {line} des Probelaufs fährt Z auf {z:g}, aber Z muss auf "
        "{height:g} oder höher bleiben. Nichts wurde gesendet.",
        "Dies dem Hersteller von knifetip melden, mit dem Programm des Auftrags.",
    ),
    "dry-run.unknown-line": Text(
        "Zeile {line} des Programms ist in einem Probelauf über dem Karton nicht möglich: "
        "„{text}“. Nichts wurde gesendet.",
        "Den Auftrag neu berechnen. Mit einem von Hand geänderten Programm ist kein Probelauf "
        "möglich.",
    ),
    "dry-run.uses-machine": Text(
        "Die Maschine macht einen Probelauf über dem Karton.",
        "Warten, bis der Probelauf beendet ist, oder ihn zuerst stoppen.",
    ),
    "tool-check.in-zone": Text(
        "Der Punkt liegt in der Sperrzone {zone} oder so nahe, dass das Werkzeug sie berühren "
        "würde. Nichts hat sich bewegt.",
        "Einen anderen Punkt wählen.",
    ),
    "tool-check.large-shift": Text(
        "Bei einer Werkzeugprüfung kann eine Station um höchstens {largest:g} mm oder Grad "
        "korrigiert werden.",
        "Den Versatz der Station neu messen und in der Maschinendatei ändern.",
    ),
    "tool-check.not-lowered": Text(
        "Das Werkzeug ist über dem Punkt, wurde aber nicht gesenkt: Z müsste auf {target:.1f} "
        "fahren, und sein Verfahrweg endet bei {lowest:g}.",
        "Das Werkzeug von oben prüfen. Muss es tiefer, das Z der Station in der Maschinendatei "
        "berichtigen.",
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
