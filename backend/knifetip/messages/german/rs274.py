"""rs274: German texts of the messages of ``catalogue.rs274``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "rs274.active-comment": Text(
        "LinuxCNC führt den Kommentar in der Programmzeile aus.",
        "Das Komma aus dem Kommentar entfernen oder den Kommentar löschen.",
    ),
    "rs274.after-end": Text(
        "Die Programmzeile kommt nach dem Ende des Programms (M2 oder M30).",
        "Die Programmzeile löschen.",
    ),
    "rs274.arc-of-other-carriage": Text(
        "Die Programmzeile hat einen Kreisbogen (G2 oder G3), während eine Station eines weiteren "
        "Schlittens gewählt ist. Steuerungen machen Kreisbögen nur mit X und Y, die den ersten "
        "Schlitten bewegen.",
        "Den Kreisbogen durch kurze Linien (G1) mit den Buchstaben der Achsen des Schlittens "
        "ersetzen.",
    ),
    "rs274.arc-on-chord-machine": Text(
        "Die Programmzeile ist ein Kreisbogen (G2, G3), dem die Steuerung von {machine} nicht "
        "folgen kann.",
        "Das Programm neu machen, oder in der Maschinendatei arcs auf „arcs“ setzen, wenn die "
        "Steuerung Kreisbögen hat und das Werkzeug darin dreht.",
    ),
    "rs274.axis-without-motion": Text(
        "Die Programmzeile hat Koordinaten, aber kein Bewegungswort (G0, G1, G2 oder G3).",
        "G0, G1, G2 oder G3 ergänzen.",
    ),
    "rs274.bad-arc": Text(
        "In der Programmzeile unterscheiden sich die Abstände des Kreismittelpunkts vom Anfang "
        "und vom Ende des Kreisbogens um mehr als {limit:g} mm.",
        "Den Mittelpunkt (I, J) oder das Ende (X, Y) des Kreisbogens berichtigen.",
    ),
    "rs274.bad-character": Text(
        "Das Zeichen „{character}“ ist an dieser Stelle der Programmzeile nicht erlaubt.",
        "Das Zeichen entfernen.",
    ),
    "rs274.bad-feed": Text(
        "Der Vorschub (F) in der Programmzeile ist 0 oder negativ.",
        "Einen Vorschub größer als 0 angeben.",
    ),
    "rs274.bad-line-number": Text(
        "Die Zeilennummer (N) in der Programmzeile ist negativ, nicht ganzzahlig oder nicht am "
        "Zeilenanfang.",
        "Die Zeilennummer berichtigen oder löschen.",
    ),
    "rs274.centre-without-arc": Text(
        "Die Programmzeile hat den Mittelpunkt eines Kreisbogens (I, J), aber keine Kreisbewegung "
        "(G2 oder G3).",
        "G2 oder G3 ergänzen oder I und J löschen.",
    ),
    "rs274.change-without-station": Text(
        "Die Programmzeile wechselt das Werkzeug (M6), aber vorher wurde keine Station (T) "
        "gewählt.",
        "Das T-Wort der Station vor M6 schreiben.",
    ),
    "rs274.control-byte": Text(
        "Die Programmzeile enthält das Byte {byte}, einen Steuerbefehl, den die Steuerung sofort "
        "ausführen würde, auch in einem Kommentar.",
        "Das Byte entfernen.",
    ),
    "rs274.ends-lowered": Text(
        "Das Programm endet mit gesenkter Station.",
        "Vor dem Ende des Programms die Station anheben (M65) und den Kopf heben.",
    ),
    "rs274.ends-oscillating": Text(
        "Das Programm endet mit oszillierendem oder drehendem Werkzeug.",
        "Das Werkzeug vor dem Ende des Programms ausschalten (M5).",
    ),
    "rs274.ends-output-on": Text(
        "Das Programm endet mit eingeschaltetem Ausgang.",
        "Den Ausgang vor dem Ende des Programms ausschalten (M65).",
    ),
    "rs274.ends-with-offset": Text(
        "Das Programm endet mit wirksamem Versatz einer Station.",
        "Den Versatz vor dem Ende des Programms aufheben (G49).",
    ),
    "rs274.g64-unsupported": Text(
        "Die Programmzeile enthält G64, das die Steuerung dieser Maschine nicht unterstützt.",
        "G64 entfernen.",
    ),
    "rs274.incomplete-arc": Text(
        "Dem Kreisbogen in der Programmzeile fehlt X, Y, I oder J.",
        "X, Y, I und J angeben.",
    ),
    "rs274.letter-without-number": Text(
        "Auf den Buchstaben {letter} in der Programmzeile folgt keine Zahl.",
        "Die Zahl ergänzen oder den Buchstaben löschen.",
    ),
    "rs274.line-too-long": Text(
        "Die Programmzeile ist länger als {limit} Zeichen, die Grenze der Steuerung.",
        "Die Zeile kürzen.",
    ),
    "rs274.missing-p": Text(
        "Ein Befehl in der Programmzeile braucht ein P-Wort, aber die Zeile hat keines.",
        "Das P-Wort ergänzen.",
    ),
    "rs274.mode-g17": Text(
        "die XY-Ebene (G17)",
    ),
    "rs274.mode-g21": Text(
        "die Einheit Millimeter (G21)",
    ),
    "rs274.mode-g40": Text(
        "Radiuskorrektur aus (G40)",
    ),
    "rs274.mode-g49": Text(
        "Werkzeuglängenkorrektur aus (G49)",
    ),
    "rs274.mode-g54": Text(
        "das Werkstückkoordinatensystem (G54)",
    ),
    "rs274.mode-g90": Text(
        "absolute Koordinaten (G90)",
    ),
    "rs274.mode-g91-1": Text(
        "Kreismittelpunkte relativ zum Anfang des Kreisbogens (G91.1)",
    ),
    "rs274.mode-g92-1": Text(
        "keine Verschiebung der Koordinaten (G92.1)",
    ),
    "rs274.mode-g94": Text(
        "den Vorschub in mm/min (G94)",
    ),
    "rs274.motion-without-axis": Text(
        "Die Programmzeile hat ein Bewegungswort (G0 bis G3), aber keine Koordinaten.",
        "Die Koordinaten ergänzen oder das Bewegungswort löschen.",
    ),
    "rs274.moves-and-switches": Text(
        "Die Programmzeile bewegt den Kopf und schaltet zugleich einen Ausgang oder die Spindel.",
        "Bewegung und Schaltbefehl in getrennte Programmzeilen schreiben.",
    ),
    "rs274.moves-other-carriage": Text(
        "Die Vorschubzeile bewegt eine Achse eines anderen Schlittens als dem der gewählten "
        "Station.",
        "Andere Schlitten nur im Eilgang (G0) bewegen oder eine Station des anderen Schlittens "
        "wählen.",
    ),
    "rs274.moves-unstated": Text(
        "Die Programmzeile bewegt den Kopf, bevor das Programm {mode} gesetzt hat.",
        "Diesen Modus am Anfang des Programms setzen.",
    ),
    "rs274.nested-comment": Text(
        "In der Programmzeile beginnt ein Kommentar in einem anderen.",
        "Den ersten Kommentar schließen, bevor der zweite beginnt.",
    ),
    "rs274.no-end": Text(
        "Das Programm hat kein Ende (M2 oder M30).",
        "M2 als letzte Zeile des Programms ergänzen.",
    ),
    "rs274.no-feed": Text(
        "Die Programmzeile schneidet, aber seit der Wahl des Vorschubmodus (G93 oder G94) wurde "
        "kein Vorschub (F) gesetzt.",
        "Ein F-Wort ergänzen.",
    ),
    "rs274.not-settled": Text(
        "Die Programmzeile bewegt den Kopf zu bald nach dem Schalten eines Ausgangs oder der "
        "Spindel.",
        "Vor dieser Programmzeile eine Verweilzeit (G4) einfügen.",
    ),
    "rs274.number-too-large": Text(
        "Eine Zahl in der Programmzeile ist größer als 1.000.000.",
        "Die Zahl berichtigen.",
    ),
    "rs274.offset-without-station": Text(
        "Die Programmzeile wendet den Versatz einer Station an (G43), aber vorher wurde keine "
        "Station (T) gewählt.",
        "Das T-Wort der Station vor G43 schreiben.",
    ),
    "rs274.open-comment": Text(
        "Ein Kommentar in der Programmzeile ist nicht geschlossen.",
        "Den Kommentar in derselben Programmzeile mit einer Klammer schließen.",
    ),
    "rs274.repeated-word": Text(
        "Die Programmzeile hat zwei Wörter, die denselben Wert setzen.",
        "Eines der beiden Wörter löschen.",
    ),
    "rs274.spindle-of-other-station": Text(
        "Die Station fährt, während die Spindel oder Oszillation einer anderen Station an ist.",
        "Sie ausschalten (M5), bevor die Station gewechselt wird.",
    ),
    "rs274.wrong-direction": Text(
        "Die Programmzeile schaltet die Spindel in der falschen Richtung für die Station ein.",
        "Das Wort verwenden, das die Maschine für die Station nennt: M3 oder M4.",
    ),
    "rs274.speed-without-m3": Text(
        "Die Programmzeile hat eine Spindeldrehzahl (S), aber weder M3 noch M4.",
        "M3 oder M4 ergänzen oder die Drehzahl löschen.",
    ),
    "rs274.stray-p": Text(
        "Das P-Wort gehört zu keinem Befehl der Programmzeile oder zu mehr als einem.",
        "Das P-Wort löschen oder die Befehle in getrennte Programmzeilen schreiben.",
    ),
    "rs274.stray-q": Text(
        "Das Q-Wort gehört zu keinem Befehl der Programmzeile.",
        "Das Q-Wort löschen.",
    ),
    "rs274.switches-while-moving": Text(
        "Die Programmzeile schaltet einen Ausgang, während der Kopf vielleicht noch fährt: Die "
        "Steuerung schaltet Ausgänge (M64, M65), sobald sie den Befehl liest.",
        "Nach der letzten Bewegung und vor dieser Programmzeile eine Verweilzeit (G4 P0) einfügen.",
    ),
    "rs274.timed-without-f": Text(
        "Die Programmzeile fährt im zeitreziproken Modus (G93), hat aber kein F-Wort.",
        "Das F-Wort ergänzen.",
    ),
    "rs274.too-many-digits": Text(
        "Eine Zahl in der Programmzeile hat mehr als 15 Ziffern.",
        "Die Zahl runden.",
    ),
    "rs274.unbounded-rounding": Text(
        "Die Programmzeile schneidet, aber das Programm begrenzt nicht, wie weit die Steuerung "
        "Ecken runden darf.",
        "Die Grenze vor dieser Programmzeile mit G64 P setzen.",
    ),
    "rs274.unknown-letter": Text(
        "Der Buchstabe {letter} in der Programmzeile wird nicht unterstützt.",
        "Den Buchstaben und seine Zahl entfernen.",
    ),
    "rs274.unknown-output": Text(
        "Die Programmzeile schaltet einen Ausgang, den {machine} nicht hat.",
        "Einen Ausgang wählen, den die Maschinendatei nennt.",
    ),
    "rs274.unknown-station": Text(
        "Die Programmzeile wählt eine Station (T), die {machine} nicht hat.",
        "Eine Station wählen, die die Maschinendatei nennt.",
    ),
    "rs274.unknown-word": Text(
        "Das Wort {word} in der Programmzeile wird nicht unterstützt.",
        "Das Wort entfernen.",
    ),
    "rs274.wrong-dwell": Text(
        "Die Verweilzeit (G4) in der Programmzeile ist kürzer als die {settle:g} s, die die "
        "Maschine nach dem Schalten braucht.",
        "Die Verweilzeit auf mindestens {settle:g} s setzen.",
    ),
    "rs274.wrong-speed": Text(
        "Die Spindeldrehzahl (S) bei M3 oder M4 weicht von der Drehzahl der Station in der "
        "Maschinendatei ab.",
        "Die Drehzahl berichtigen oder den Auftrag neu berechnen.",
    ),
}
