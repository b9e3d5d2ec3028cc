"""testpiece: German texts of the messages of ``catalogue.testpiece``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "testpiece.all-through": Text(
        "Schon der erste Schnitt geht durch: Das Messer ist um mehr als {reach:.3g} mm tiefer als "
        "programmiert.",
        "Den Versatz der Station in Z um dieses Maß erhöhen und das Stück noch einmal schneiden.",
    ),
    "testpiece.bad-range": Text(
        "Der Bereich der guten Laschen braucht eine erste und eine letzte; die erste darf nicht "
        "größer als die letzte sein.",
        "Beide Nummern des Kamms eingeben oder beide leer lassen.",
    ),
    "testpiece.crease-depth": Text(
        "Rilltiefe",
    ),
    "testpiece.crease-depth.description": Text(
        "Zwei Kämme mit Laschen, längs und quer zur Faser zunehmend tief gerillt",
    ),
    "testpiece.crease-depth.instruction": Text(
        "Jede Lasche falten, gezählt von der schrägen Ecke an: Kamm A ist längs zur Faser gerillt, "
        "Kamm B quer. Die erste Lasche notieren, die gefaltet bleibt, und die letzte, deren Decke "
        "nicht reißt.",
    ),
    "testpiece.deflection": Text(
        "Ablenkung eines Fräsers",
    ),
    "testpiece.deflection.description": Text(
        "Ein gefrästes Rechteck, dessen Seiten zeigen, wie weit das Material den Fräser wegdrückt",
    ),
    "testpiece.deflection.instruction": Text(
        "Breite und Höhe des Rechtecks in der Mitte der Seiten mit dem Messschieber messen.",
    ),
    "testpiece.figure.angle": Text(
        "Winkel zwischen den Achsen X und Y",
    ),
    "testpiece.figure.back": Text(
        "d, Abstand der Spitze von der Achse, quer zur Klinge",
    ),
    "testpiece.figure.crease-across": Text(
        "Rilltiefe quer zur Faser",
    ),
    "testpiece.figure.crease-along": Text(
        "Rilltiefe längs zur Faser",
    ),
    "testpiece.figure.deflection-x": Text(
        "Ablenkung in X",
    ),
    "testpiece.figure.deflection-y": Text(
        "Ablenkung in Y",
    ),
    "testpiece.figure.half-width": Text(
        "r, Abstand der Spitze von der Achse, längs der Klinge",
    ),
    "testpiece.figure.offset-x": Text(
        "Versatz der Station in X",
    ),
    "testpiece.figure.offset-y": Text(
        "Versatz der Station in Y",
    ),
    "testpiece.figure.offset-z": Text(
        "Versatz der Station in Z",
    ),
    "testpiece.figure.pulses-x": Text(
        "Impulse je mm von X",
    ),
    "testpiece.figure.pulses-y": Text(
        "Impulse je mm von Y",
    ),
    "testpiece.figure.scale-x": Text(
        "Maßstab von X (gefahren / gezeichnet)",
    ),
    "testpiece.figure.scale-y": Text(
        "Maßstab von Y (gefahren / gezeichnet)",
    ),
    "testpiece.implausible": Text(
        "{measure} ist {value:g} mm, gezeichnet sind {drawn:g} mm; das Maß ist nicht plausibel.",
        "Maß und Einheit prüfen. Ist es richtig, zuerst die Maschine grob einstellen.",
    ),
    "testpiece.impossible": Text(
        "Der neue Wert wäre {value:.4g} mm, er muss aber mindestens {least:g} mm sein.",
        "Maß und Vorzeichen prüfen.",
    ),
    "testpiece.knife-depth": Text(
        "Tiefe eines Messers",
    ),
    "testpiece.knife-depth.description": Text(
        "Eine Reihe kurzer Schnitte, jeder tiefer als der vorige",
    ),
    "testpiece.knife-depth.instruction": Text(
        "Das Stück umdrehen. Die Schnitte von der abgeschnittenen Ecke an zählen (jeder fünfte ist "
        "länger) und den ersten notieren, der unten auf ganzer Länge zu sehen ist.",
    ),
    "testpiece.no-depth": Text(
        "Programme für {machine} stellen die Tiefe eines Werkzeugs nicht ein; sie kann nicht "
        "gemessen werden.",
        "Die Tiefe an der Maschine einstellen.",
    ),
    "testpiece.no-knife": Text(
        "{machine} schneidet ohne Messer; nur Schnitte eines Messers sind ein Bezug für den "
        "Versatz eines anderen Werkzeugs.",
        "Den Versatz mit der Werkzeugprüfung an der Station einstellen.",
    ),
    "testpiece.no-parallelogram": Text(
        "Seiten und Diagonalen weichen um {difference:.3g} mm von denen jedes Parallelogramms ab.",
        "Noch einmal messen, jeweils von Ecke zu Ecke, und die Ablesegenauigkeit eingeben.",
    ),
    "testpiece.none-through": Text(
        "Kein Schnitt geht durch: Das Messer ist um mehr als {reach:.3g} mm flacher als "
        "programmiert.",
        "Den Versatz der Station in Z um dieses Maß verringern und das Stück noch einmal "
        "schneiden.",
    ),
    "testpiece.nothing-measured": Text(
        "Kein Kamm wurde beurteilt.",
        "Die erste und die letzte gute Lasche von Kamm A, Kamm B oder beiden eingeben.",
    ),
    "testpiece.other-station": Text(
        "In diesem Material macht Station {station} keine Linien der Art {type}. Die Station, die "
        "sie macht: {other} (0: keine).",
        "Ein Material wählen, das zum Werkzeug der Station passt, oder die andere Station.",
    ),
    "testpiece.other-tool": Text(
        "Das Werkzeug von Station {station} wird nicht mit diesem Teststück gemessen.",
        "Ein anderes Teststück oder eine andere Station wählen.",
    ),
    "testpiece.squareness": Text(
        "Rechtwinkligkeit und Maßstab",
    ),
    "testpiece.squareness.description": Text(
        "Ein Rechteck, dessen Seiten und Diagonalen Maßstab und Winkel der Achsen zeigen",
    ),
    "testpiece.squareness.instruction": Text(
        "Beide Seiten und beide Diagonalen mit Stahlmaßstab oder langem Messschieber messen. Der "
        "Schlitz liegt neben der linken unteren Ecke.",
    ),
    "testpiece.station-offset": Text(
        "Versatz einer Station",
    ),
    "testpiece.station-offset.description": Text(
        "Linien des Werkzeugs 20 mm neben Linien des Messers, längs X und Y",
    ),
    "testpiece.station-offset.instruction": Text(
        "Vom Schnitt bis zur Mitte der Linie des Werkzeugs daneben messen, einmal längs X und "
        "einmal längs Y.",
    ),
    "testpiece.unknown-station": Text(
        "{machine} hat keine Station {station}.",
        "Eine Station der Maschine wählen.",
    ),
    "testpiece.v-cutter": Text(
        "Versatz eines V-Messers",
    ),
    "testpiece.v-cutter.description": Text(
        "Nuten aus zwei gegenläufigen Schnitten, deren Spuren sich treffen sollen",
    ),
    "testpiece.v-cutter.instruction": Text(
        "Die Nut am rechten Rand mit der Lupe ansehen und den Abstand der beiden Schnitte an ihrem "
        "Grund messen. Dann einen Schnitt der inneren Nut an der Oberseite messen; die Marken "
        "daneben haben 1 mm Abstand und beginnen an den Enden der Linie.",
    ),
}
