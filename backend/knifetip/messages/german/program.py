"""program: German texts of the messages of ``catalogue.program``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "motion.feed": Text(
        "Schneidbewegung",
    ),
    "motion.lead-in": Text(
        "Anlauf",
    ),
    "motion.lead-out": Text(
        "Auslauf",
    ),
    "motion.lift": Text(
        "Abheben",
    ),
    "motion.plunge": Text(
        "Eintauchen",
    ),
    "motion.rapid": Text(
        "Eilgang",
    ),
    "motion.swivel": Text(
        "Drehen des Werkzeugs",
    ),
    "motion.unknown": Text(
        "unbekannte Bewegungsart {number}",
    ),
    "program.bad-tolerance": Text(
        "Eine Toleranz von {tolerance} mm ist für das Überschleifen (Runden von Ecken) der "
        "Steuerung zu klein.",
        "Eine Toleranz von 0,001 mm oder mehr wählen.",
    ),
    "program.control-byte": Text(
        "Zeile {line} des Programms enthält das Byte 0x{byte}, einen Steuerbefehl, den die "
        "Steuerung sofort ausführen würde.",
        "Das Byte entfernen oder den Auftrag neu berechnen.",
    ),
    "program.line-too-long": Text(
        "Eine Programmzeile für Zeile {row} des Werkzeugwegs hat {length} Zeichen ({line} …), "
        "aber {dialect} nimmt nur {limit} Zeichen an.",
        "Die Koordinaten der Zeichnung prüfen. Sie sind zu groß für jeden Tisch.",
    ),
    "program.line-too-long-to-send": Text(
        "Zeile {line} des Programms hat {length} Bytes, aber {name} nimmt nur {limit} Bytes an.",
        "Den Fehler mit der Programmdatei melden.",
    ),
    "program.no-placement": Text(
        "{program} enthält nicht die Lage der Zeichnung auf dem Bogen.",
        "Die Lage mit --placement X,Y angeben. Der Bericht, den knifetip program --report "
        "schreibt, enthält sie.",
    ),
    "program.not-bytes": Text(
        "Das Programm ist vom Typ {type}, muss aber bytes sein.",
        "Den Inhalt der Datei als bytes übergeben.",
    ),
    "program.not-fetched": Text(
        "Das Programm von Auftrag {job} konnte nicht vom Server geladen werden ({reason}). Nichts "
        "wurde an die Maschine gesendet.",
        "Den Auftrag noch einmal einreihen.",
    ),
    "program.too-large": Text(
        "Das Programm hat {bytes:,} Bytes, erlaubt sind {limit:,}.",
        "Den Auftrag auf mehrere Bogen verteilen.",
    ),
    "program.too-many-lines": Text(
        "Das Programm hat {lines:,} Zeilen, erlaubt sind {limit:,}.",
        "Den Auftrag auf mehrere Bogen verteilen.",
    ),
    "program.too-many-moves": Text(
        "Das Programm hat {moves:,} Bewegungen, erlaubt sind {limit:,}.",
        "Den Auftrag auf mehrere Bogen verteilen.",
    ),
    "program.wrong-checksum": Text(
        "Das Programm von Auftrag {job} wurde bei der Übertragung vom Server beschädigt (SHA-256 "
        "{arrived}… statt {expected}…). Nichts wurde an die Maschine gesendet.",
        "Den Auftrag noch einmal einreihen. Geschieht es wieder, den Auftrag neu berechnen.",
    ),
    "toolpath.arc-too-long": Text(
        "Interner Fehler: {place} ist ein Kreisbogen von mehr als 180°: {move}.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "toolpath.empty": Text(
        "Der Werkzeugweg hat keine Bewegungen, also würde nichts geschnitten.",
        "Mindestens einer Kante eine Linienart geben, für die die Maschine ein Werkzeug hat.",
    ),
    "toolpath.feed-too-fast": Text(
        "{place} hat einen Vorschub, der für jede Maschine zu schnell ist: {move}.",
        "Den Vorschub des Werkzeugs in der Maschinendatei berichtigen.",
    ),
    "toolpath.move": Text(
        "von ({start:; }) nach ({end:; }), Wölbung {bulge}, Vorschub {feed}",
    ),
    "toolpath.no-approach": Text(
        "Interner Fehler: {place} beginnt einen Schnitt mit Station {station}, aber kein Eilgang "
        "führt zu seinem Anfang.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "toolpath.no-feed": Text(
        "{place} hat keinen Vorschub: {move}.",
        "Den Vorschub des Werkzeugs in der Maschinendatei setzen.",
    ),
    "toolpath.not-finite": Text(
        "Interner Fehler: {place} hat einen Wert, der keine Zahl ist: {move}.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "toolpath.rapid-arc": Text(
        "Interner Fehler: {place} ist ein Eilgang auf einem Kreisbogen: {move}.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "toolpath.row": Text(
        "Zeile {row} des Werkzeugwegs ({motion})",
    ),
    "toolpath.row-of-edge": Text(
        "Zeile {row} des Werkzeugwegs ({motion}, Kante {edge})",
    ),
    "toolpath.swivel-without-turn": Text(
        "Interner Fehler: Zeile {row} des Werkzeugwegs bewegt den Kopf um die Werkzeugspitze, "
        "ohne das Werkzeug zu drehen, der Vorschub in Grad je Minute ist also nicht bestimmt.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "toolpath.too-far": Text(
        "{place} ist mehr als {limit:g} mm vom Nullpunkt entfernt: {move}.",
        "Die Einheit der Zeichnung prüfen.",
    ),
    "toolpath.unknown-motion": Text(
        "Interner Fehler: {place} hat eine unbekannte Bewegungsart: {move}.",
        "Den Fehler mit der Zeichnung melden.",
    ),
    "toolpath.unknown-station": Text(
        "{place} benutzt Station {station}, die {machine} nicht hat.",
        "Eine der Stationen {known:, } wählen.",
    ),
    "travel.above": Text(
        "{tool} (Station {station}) würde {excess:.2f}{unit} über das obere Ende des Verfahrwegs "
        "der Achse {axis} hinausfahren. Der Verfahrweg ist {low:g} bis {high:g}{unit}. {place}",
        "Bei Achse X, Y oder C die Zeichnung auf dem Tisch versetzen oder drehen oder eine "
        "größere Maschine wählen. Bei Achse Z die Höhen in der Maschinendatei prüfen.",
    ),
    "travel.heads-too-near": Text(
        "{tool} (Station {station}) käme dem geparkten Schlitten {other} bis auf {distance:.2f} "
        "mm nahe. Schlitten müssen mindestens {least:g} mm Abstand halten. {place}",
        "Die Zeichnung in Y vom geparkten Schlitten wegschieben oder die Linienart einem Werkzeug "
        "auf dem anderen Schlitten geben.",
    ),
    "travel.below": Text(
        "{tool} (Station {station}) würde {excess:.2f}{unit} über das untere Ende des Verfahrwegs "
        "der Achse {axis} hinausfahren. Der Verfahrweg ist {low:g} bis {high:g}{unit}. {place}",
        "Bei Achse X, Y oder C die Zeichnung auf dem Tisch versetzen oder drehen oder eine "
        "größere Maschine wählen. Bei Achse Z die Höhen in der Maschinendatei prüfen.",
    ),
    "language.bad-entry-point": Text(
        "Der Python-Einstiegspunkt „{name}“ der Gruppe {group} muss eine Steuerungssprache mit "
        "dem Namen „{name}“ liefern, liefert aber keine.",
        "Das Python-Paket berichtigen oder entfernen, das den Einstiegspunkt angibt.",
    ),
    "language.no-driver": Text(
        "Programme in {language} können nicht an eine Maschine gesendet werden, weil das Gateway "
        "keinen Treiber für diese Sprache hat.",
        "{advice}",
    ),
    "language.default-outputs": Text(
        "die Maschine nennt die Anzahl der digitalen Ausgänge ihrer Steuerung nicht, und "
        "{language} hat üblicherweise {count}, ab 0 gezählt, also gibt es diese Ausgänge nicht: "
        "{outputs:, }",
        "Andere Ausgänge verwenden oder `output_count` auf die Anzahl setzen, für die die "
        "Steuerung eingerichtet ist.",
    ),
    "language.few-outputs": Text(
        "die Steuerung mit {language} hat {count:# digitalen Ausgang|# digitale Ausgänge}, ab 0 "
        "gezählt, also gibt es diese Ausgänge nicht: {outputs:, }",
        "Andere Ausgänge verwenden oder `output_count` berichtigen.",
    ),
    "language.no-linear-axis": Text(
        "Schlitten {carriage} hat eine Linearachse {letter}, aber {language} hat keine solche "
        "Achse. Seine Linearachsen sind {known:, }",
        "Den Buchstaben der Achse oder die Sprache (dialect) der Maschine ändern.",
    ),
    "language.no-rotary-axis": Text(
        "Schlitten {carriage} hat eine Drehachse {letter}, aber {language} hat keine solche Achse. "
        "Seine Drehachsen sind {known:, }",
        "Den Buchstaben der Achse oder die Sprache (dialect) der Maschine ändern.",
    ),
    "language.no-settings": Text(
        "{path} ist nicht erlaubt, weil {language} keine Einstellungen hat",
        "Den Abschnitt [controller] entfernen.",
    ),
    "language.unknown": Text(
        "Die Steuerungssprache „{name}“ gibt es nicht.",
        "Eine von {known:, } wählen.",
    ),
    "language.unusable": Text(
        "{machine} kann nicht mit Programmen in {language} gesteuert werden: {faults:; }.",
        "{faults:hint} Die Sprache {own} wählen, die die Maschinendatei nennt.",
    ),
}
