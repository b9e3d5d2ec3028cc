"""grbl: German texts of the messages of ``catalogue.grbl``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "grbl.alarm-1": Text(
        "ein Endschalter wurde ausgelöst, also ist die Position der Maschine verloren",
        "Prüfen, woran der Kopf gestoßen ist. Eine Referenzfahrt machen, oder die Maschine "
        "entsperren und vom Schalter wegfahren.",
    ),
    "grbl.alarm-10": Text(
        "ein Not-Halt-Taster ist gedrückt",
        "Den Not-Halt-Taster lösen, wenn der Tisch sicher ist, dann eine Referenzfahrt machen.",
    ),
    "grbl.alarm-11": Text(
        "die Maschine braucht zuerst eine Referenzfahrt",
        "Den Tisch räumen, dann eine Referenzfahrt machen.",
    ),
    "grbl.alarm-12": Text(
        "ein Endschalter ist ausgelöst",
        "Die Maschine entsperren, vom Schalter wegfahren, dann eine Referenzfahrt machen.",
    ),
    "grbl.alarm-14": Text(
        "die Spindel hat ihre Drehzahl nicht erreicht",
        "Die Spindel und ihr Kabel prüfen, dann die Maschine entsperren.",
    ),
    "grbl.alarm-17": Text(
        "ein Motortreiber meldet eine Störung",
        "Die Motortreiber und ihre Versorgung prüfen, dann eine Referenzfahrt machen.",
    ),
    "grbl.alarm-2": Text(
        "eine Bewegung wäre über den Verfahrweg der Maschine hinausgegangen",
        "Den Werkstücknullpunkt und die Lage des Auftrags prüfen, dann die Maschine entsperren.",
    ),
    "grbl.alarm-3": Text(
        "die Steuerung wurde während einer Bewegung zurückgesetzt, also ist die Position der "
        "Maschine vielleicht verloren",
        "Den Tisch prüfen, dann eine Referenzfahrt machen.",
    ),
    "grbl.alarm-4": Text(
        "der Taster war vor dem Antasten nicht im erwarteten Zustand",
        "Den Taster und sein Kabel prüfen, dann die Maschine entsperren.",
    ),
    "grbl.alarm-5": Text(
        "der Taster hat das Werkstück nicht berührt",
        "Den Taster und den Karton prüfen, dann die Maschine entsperren.",
    ),
    "grbl.alarm-6": Text(
        "die Steuerung wurde während der Referenzfahrt zurückgesetzt",
        "Den Tisch räumen, dann die Referenzfahrt wiederholen.",
    ),
    "grbl.alarm-7": Text(
        "die Schutztür wurde während der Referenzfahrt geöffnet",
        "Die Schutztür schließen, dann die Referenzfahrt wiederholen.",
    ),
    "grbl.alarm-8": Text(
        "der Endschalter blieb ausgelöst, als die Maschine bei der Referenzfahrt von ihm wegfuhr",
        "Die Endschalter und ihre Kabel prüfen, dann eine Referenzfahrt machen.",
    ),
    "grbl.alarm-9": Text(
        "die Referenzfahrt hat den Endschalter nicht erreicht",
        "Die Endschalter und ihre Kabel prüfen, dann eine Referenzfahrt machen.",
    ),
    "grbl.error-1": Text(
        "vor einer Zahl fehlt der Buchstabe",
    ),
    "grbl.error-10": Text(
        "Softwaregrenzen sind nur mit eingeschalteter Referenzfahrt möglich",
    ),
    "grbl.error-11": Text(
        "die Zeile ist zu lang",
    ),
    "grbl.error-12": Text(
        "die Einstellung übersteigt die höchste Schrittrate der Steuerung",
    ),
    "grbl.error-13": Text(
        "eine Schutztür ist offen",
    ),
    "grbl.error-14": Text(
        "die Startzeile oder die Build-Information ist zu lang zum Speichern",
    ),
    "grbl.error-15": Text(
        "das Ziel der Tippbewegung liegt außerhalb des Verfahrwegs der Maschine",
    ),
    "grbl.error-16": Text(
        "der Befehl zum Tippen hat keinen Vorschub oder enthält ein Wort, das darin nicht erlaubt "
        "ist",
    ),
    "grbl.error-17": Text(
        "der Laserbetrieb braucht einen PWM-Ausgang",
    ),
    "grbl.error-18": Text(
        "die Steuerung wurde zurückgesetzt, also hat sie den Befehl nicht ausgeführt",
    ),
    "grbl.error-2": Text(
        "eine Zahl fehlt oder ist nicht lesbar",
    ),
    "grbl.error-20": Text(
        "die Steuerung unterstützt diesen Befehl nicht",
    ),
    "grbl.error-21": Text(
        "die Zeile hat zwei Befehle einer Modalgruppe, zum Beispiel G0 und G1",
    ),
    "grbl.error-22": Text(
        "kein Vorschub wurde gesetzt",
    ),
    "grbl.error-23": Text(
        "die Nummer des Befehls muss ganzzahlig sein",
    ),
    "grbl.error-24": Text(
        "die Zeile hat zwei Befehle, die beide Achswörter brauchen",
    ),
    "grbl.error-25": Text(
        "ein Wort kommt in der Zeile doppelt vor",
    ),
    "grbl.error-26": Text(
        "der Zeile fehlen die Achswörter, die ihr Befehl braucht",
    ),
    "grbl.error-27": Text(
        "die Zeilennummer liegt außerhalb ihres Bereichs",
    ),
    "grbl.error-28": Text(
        "dem Befehl fehlt sein P- oder L-Wort",
    ),
    "grbl.error-29": Text(
        "die Steuerung unterstützt dieses Werkstückkoordinatensystem nicht",
    ),
    "grbl.error-3": Text(
        "die Steuerung unterstützt diesen $-Befehl nicht",
    ),
    "grbl.error-30": Text(
        "G53 steht ohne G0 oder G1",
    ),
    "grbl.error-31": Text(
        "die Zeile hat Achswörter (X, Y, Z), aber keinen Befehl, der sie verwendet",
    ),
    "grbl.error-32": Text(
        "der Kreisbogen hat keine Achswörter in seiner Ebene",
    ),
    "grbl.error-33": Text(
        "Anfang und Ende des Kreisbogens liegen nicht auf einem Kreis",
    ),
    "grbl.error-34": Text(
        "der Radius des Kreisbogens ist nicht berechenbar",
    ),
    "grbl.error-35": Text(
        "der Kreisbogen hat keinen Mittelpunkt, weil I und J fehlen",
    ),
    "grbl.error-36": Text(
        "die Zeile hat Wörter (Buchstabe mit Zahl), die kein Befehl verwendet",
    ),
    "grbl.error-37": Text(
        "die Werkzeuglängenkorrektur gilt der falschen Achse",
    ),
    "grbl.error-38": Text(
        "die Werkzeugnummer ist zu hoch",
    ),
    "grbl.error-39": Text(
        "ein Wert liegt außerhalb seines Bereichs",
    ),
    "grbl.error-4": Text(
        "ein Wert ist negativ, muss aber positiv sein",
    ),
    "grbl.error-5": Text(
        "die Referenzfahrt ist in den Einstellungen der Steuerung ausgeschaltet",
    ),
    "grbl.error-6": Text(
        "der Schrittimpuls ist zu kurz",
    ),
    "grbl.error-60": Text(
        "die Speicherkarte der Steuerung konnte nicht geöffnet werden",
    ),
    "grbl.error-7": Text(
        "die Einstellungen der Steuerung waren nicht lesbar, also wurden die Vorgaben "
        "wiederhergestellt",
    ),
    "grbl.error-79": Text(
        "ein Not-Halt-Taster ist gedrückt",
    ),
    "grbl.error-8": Text(
        "der Befehl ist nur erlaubt, während die Steuerung frei ist",
    ),
    "grbl.error-9": Text(
        "die Steuerung ist durch einen Alarm gesperrt oder führt eine Tippbewegung aus",
    ),
    "grbl.unknown-alarm": Text(
        "der Alarmcode ist bei Grbl nicht dokumentiert",
        "Die Anleitung der Steuerung lesen und den Tisch prüfen, dann eine Referenzfahrt machen.",
    ),
    "grbl.unknown-error": Text(
        "der Fehlercode ist bei Grbl nicht dokumentiert",
    ),
    "grbl.axis-letter-used": Text(
        "die Steuerung nennt die Drehachse {letter}, und die Zeile enthält diesen Buchstaben schon",
    ),
    "grbl.no-output": Text(
        "die Steuerung hat keinen digitalen Ausgang {output} (sie hat {count:# Ausgang|# "
        "Ausgänge})",
    ),
    "grbl.no-reverse": Text(
        "dieser Build von Grbl dreht die Spindel nur in einer Richtung (Option D) und hat kein M4",
        'Einen Build ohne die Option installieren oder für die Station `spindle = "M3"` setzen.',
    ),
    "grbl.no-rotary-axis": Text(
        "die Steuerung hat keine Achse, die das Werkzeug dreht (ihre Achsen sind {axes:, })",
    ),
}
