"""corner: German texts of the messages of ``catalogue.corner``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "corner.bad-k": Text(
        "Der Parameter k der Ecke am Anfang von Kante {edge} ist {k}, muss aber zwischen 0 und 1 "
        "liegen.",
        "Ein k von 0 (die Bahn des Eckentyps B) bis 1 (die Bahn des Eckentyps C) wählen.",
    ),
    "corner.bad-share": Text(
        "Ecke {corner} in der Liste der Ecken (die erste hat die Nummer 0) hat den Typ D mit dem "
        "Parameter k = {k}, der zwischen 0 und 1 liegen muss.",
        "Ein k von 0 (die Bahn des Eckentyps B) bis 1 (die Bahn des Eckentyps C) wählen.",
    ),
    "corner.inside": Text(
        "Die Ecke bei X {x:g} mm, Y {y:g} mm ist eine Innenecke, aber Eckentypen gelten nur für "
        "Außenecken.",
        "Den Eckentyp dieser Ecke aus der Anfrage entfernen.",
    ),
    "corner.no-contour": Text(
        "Bei X {x:g} mm, Y {y:g} mm (gesucht im Umkreis von {within:g} mm) kann kein Eckentyp "
        "gesetzt werden, weil die Zeichnung keine Kontur mit gefrästen Außenecken hat.",
        "Die Eckentypen für diese Zeichnung aus der Anfrage entfernen.",
    ),
    "corner.no-cutter": Text(
        "Eckentypen wurden gewählt, aber {machine} hat keinen Fräser.",
        "Die Eckentypen aus der Anfrage entfernen oder eine Maschine mit Fräser wählen.",
    ),
    "corner.not-found": Text(
        "Im Umkreis von {within:g} mm um X {x:g} mm, Y {y:g} mm liegt keine Ecke einer gefrästen "
        "Kontur. Die nächste Ecke ist {distance:.2f} mm entfernt.",
        "X und Y einer Ecke in mm angeben, in den Koordinaten der Zeichnung. Die nächsten Ecken "
        "sind {known:, }.",
    ),
    "corner.replaced": Text(
        "{count:# Ecke hat|# Ecken haben} Typ B statt {type}, weil die Bahn des Fräsers bei Typ "
        "{type} eine andere Bahn kreuzen oder einer anderen Kante zu nahe kommen würde. X und Y "
        "auf dem Bogen in mm ({count:eine Ecke|die ersten Ecken}): {places:; }.",
        "Für {count:diese Ecke|diese Ecken} den Eckentyp B oder einen Fräser mit kleinerem "
        "Durchmesser wählen.",
    ),
    "corner.unknown-number": Text(
        "Ecke {corner} in der Liste der Ecken (die erste hat die Nummer 0) hat den Eckentyp "
        "{type}, den es nicht gibt.",
        "Eckentyp B, C oder D wählen.",
    ),
    "corner.unknown-type": Text(
        "Den Eckentyp „{type}“ gibt es nicht.",
        "Eckentyp B, C, D oder auto wählen.",
    ),
    "deflection.exceeds-radius": Text(
        "Die Durchbiegung von {deflection:.3f} mm kann nicht ausgeglichen werden, weil sie nicht "
        "kleiner ist als der Radius des Fräsers von {radius:.3f} mm.",
        "Die Durchbiegung des Fräsers noch einmal messen oder in der Materialdatei berichtigen.",
    ),
    "calibration.bad-points": Text(
        "{count:Der # Messpunkt|Die # Messpunkte} des Probeschnitts {count:kann|können} nicht "
        "verwendet werden. Mindestens ein Punkt ist nötig, und alle Werte müssen endliche Zahlen "
        "sein.",
        "Mindestens einen Punkt auf einem schrägen Stück der Kontur des Probeschnitts messen.",
    ),
    "calibration.choose-cutter": Text(
        "{machine} hat {count:# Fräser|# Fräser}, also muss der zu kalibrierende genannt werden.",
        "Einen von {cutters:, } wählen.",
    ),
    "calibration.missing-column": Text(
        "In Zeile {line} von {file} fehlt ein Wert für {columns:or}.",
        "In die erste Zeile die Überschrift azimuth,dx,dy schreiben, in jede andere drei Zahlen "
        "in Grad, mm und mm, zum Beispiel 45,-0.05,0.06.",
    ),
    "calibration.not-a-number": Text(
        "In Zeile {line} von {file} steht ein Wert, der keine Zahl ist: {values:, }.",
        "Drei Zahlen mit Dezimalpunkt schreiben, zum Beispiel 45,-0.05,0.06.",
    ),
    "calibration.not-csv": Text(
        "{file} ist keine CSV-Datei: {reason}.",
        "Die Datei als CSV in UTF-8 speichern.",
    ),
    "calibration.undetermined": Text(
        "An jedem Messpunkt verläuft die Kontur fast entlang {along}, also ist die Durchbiegung "
        "des Fräsers in {along} ({other}) nicht bestimmbar. Die Summe von sin² der Winkel "
        "zwischen der Kontur und der {along}-Achse ist {weight:.4f}, muss aber mindestens {least} "
        "sein.",
        "Einen weiteren Punkt messen, wo die Kontur entlang {direction} oder unter 45° verläuft.",
    ),
    "calibration.wrong-sign": Text(
        "Die Messpunkte ergeben eine Durchbiegung von {x:.3f} mm in X und {y:.3f} mm in Y. Ein "
        "negativer Wert bedeutet, dass der Fräser zur Kontur hin ausweicht, obwohl der Karton ihn "
        "sonst von ihr wegdrückt. Wahrscheinlich ist ein Vorzeichen oder die Seite falsch.",
        "Die Vorzeichen von dx und dy prüfen und auf welcher Seite der Kontur das Werkzeug läuft.",
    ),
}
