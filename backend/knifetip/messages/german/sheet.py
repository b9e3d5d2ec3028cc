"""sheet: German texts of the messages of ``catalogue.sheet``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "board.above-travel": Text(
        "Der Karton ist {caliper:g} mm dick, aber der Kopf von {machine} fährt nur {travel:g} mm "
        "über dem Tisch und muss {clearance:g} mm über dem Karton bleiben.",
        "Ein dünneres Material wählen oder eine Maschine, deren Kopf höher fährt.",
    ),
    "board.too-thick": Text(
        "Der Karton ist {caliper:g} mm dick, aber {machine} nimmt Karton bis {limit:g} mm.",
        "Dünneren Karton oder eine andere Maschine wählen. Die Grenze ist max_caliper in der "
        "Maschinendatei.",
    ),
    "lift.not-stated": Text(
        "Die Werkzeuge können zwischen Schnitten nicht weniger als sonst abgehoben werden, weil "
        "die Maschinendatei von {machine} nicht nennt, wie hoch (turn_clearance).",
        "Die Werkzeuge auf den Sicherheitsabstand der Maschine abheben lassen oder turn_clearance "
        "in der Maschinendatei setzen, zum Beispiel auf 0,5 mm für flach liegenden Karton.",
    ),
    "sheet.bad-size": Text(
        "„{text}“ ist keine Bogengröße.",
        "Breite und Höhe in mm als BREITExHÖHE angeben, mit dem Abstand der Zeichnung vom linken "
        "und unteren Rand als BREITExHÖHE:RAND, oder outline für einen Bogen, der auf die "
        "Außenkontur der Zeichnung zugeschnitten ist.",
    ),
    "sheet.off-table": Text(
        "Der Bogen läge von X {x:.1f}, Y {y:.1f} bis X {right:.1f}, Y {top:.1f} mm, aber der "
        "Tisch von {machine} reicht von 0 bis {width:.0f} × {height:.0f} mm.",
        "Einen kleineren Rand oder Bogen wählen oder den Nullpunkt in der Maschinendatei "
        "berichtigen.",
    ),
    "sheet.smaller-than-drawing": Text(
        "Der Bogen von {width:.1f} × {height:.1f} mm ist zu klein: Mit seinem Rand von "
        "{margin:.1f} mm braucht die Zeichnung {needed_x:.1f} × {needed_y:.1f} mm.",
        "Größe und Rand des Bogens auf dem Tisch eingeben oder die Einheit der Zeichnung prüfen.",
    ),
    "sheet.without-outline": Text(
        "Die Schnitte der Zeichnung bilden keine geschlossene Kontur um alle ihre anderen Linien, "
        "also ist die Außenkontur des Bogens nicht bekannt.",
        "Breite und Höhe des Bogens eingeben oder die Außenkontur der Zeichnung schließen.",
    ),
    "zone.work": Text(
        "{tool} (Station {station}) würde die Sperrzone {zone} bei X {x:.1f}, Y {y:.1f} mm "
        "berühren: Das Werkzeug mit seinem Halter braucht {reach:.1f} mm um seine Achse. {place}",
        "Die Klemme oder den Anschlag von der Zeichnung wegsetzen und die Zone in der "
        "Maschinendatei berichtigen, oder den Nullpunkt in der Maschinendatei so verschieben, "
        "dass die Zeichnung neben der Zone liegt.",
    ),
}
