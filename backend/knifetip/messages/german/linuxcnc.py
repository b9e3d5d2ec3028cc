"""linuxcnc: German texts of the messages of ``catalogue.linuxcnc``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "linuxcnc.bad-address": Text(
        "„{address}“ ist keine gültige Adresse von LinuxCNC.",
        "HOST:PORT schreiben, oder linuxcnc://HOST:PORT/?OPTION=WERT&OPTION=WERT mit den Optionen "
        "{options:, }; Werte haben keine Leerzeichen.",
    ),
    "linuxcnc.beyond-travel": Text(
        "Programmzeile {line} würde {axis} in Maschinenkoordinaten auf {position:.3f} {unit} "
        "fahren, über die Grenze {limit:.3f} {unit} von LinuxCNC unter {name} hinaus. Nichts hat "
        "sich bewegt.",
        "X Y Null so setzen, dass der ganze Bogen im Verfahrweg liegt, oder den Auftrag anders "
        "platzieren. Kann die Maschine weiter fahren, MIN_LIMIT und MAX_LIMIT von {axis} in der "
        "INI-Datei von LinuxCNC berichtigen.",
    ),
    "linuxcnc.cause": Text(
        "LinuxCNC meldet: {texts:; }.",
    ),
    "linuxcnc.estop": Text(
        "LinuxCNC unter {name} ist im Not-Halt.",
        "Den Tisch prüfen, den Not-Halt-Taster lösen, dann „Entsperren“ drücken, oder in LinuxCNC "
        "den Not-Halt zurücksetzen und die Maschine einschalten.",
    ),
    "linuxcnc.folder-not-writable": Text(
        "Die Programmdatei für LinuxCNC kann nicht in den Ordner {folder} geschrieben werden "
        "({reason}).",
        "Den Ordner anlegen und dem Benutzer des Gateways das Schreiben darin erlauben.",
    ),
    "linuxcnc.ini-unread": Text(
        "Das Gateway kann die INI-Datei {path} von LinuxCNC unter {name} nicht lesen, vergleicht "
        "also Grenzen, Geschwindigkeiten und Beschleunigungen nicht mit der Maschinendatei.",
        "Die Datei auf den Rechner des Gateways kopieren und ini=PFAD an die Adresse anhängen.",
    ),
    "linuxcnc.lost": Text(
        "Die Verbindung zu LinuxCNC unter {name} ist verloren. LinuxCNC führt sein Programm "
        "vielleicht weiter aus.",
        "Vom Tisch fernbleiben, bis die Maschine steht, oder den Not-Halt-Taster drücken. Dann "
        "prüfen, ob LinuxCNC und linuxcncrsh laufen.",
    ),
    "linuxcnc.machine-off": Text(
        "Die Maschine von LinuxCNC unter {name} ist ausgeschaltet.",
        "Den Tisch prüfen, dann „Entsperren“ drücken oder die Maschine in LinuxCNC einschalten.",
    ),
    "linuxcnc.not-at-rest": Text(
        "Die Maschine von LinuxCNC unter {name} ist nicht innerhalb von {seconds:g} s zum Stehen "
        "gekommen.",
        "Den Not-Halt-Taster drücken, wenn sich die Maschine noch bewegt, dann den Tisch prüfen.",
    ),
    "linuxcnc.not-begun": Text(
        "LinuxCNC unter {name} hat das Programm nicht innerhalb von {seconds:g} s begonnen.",
        "An der Maschine nach einer Meldung von LinuxCNC sehen, dann noch einmal versuchen.",
    ),
    "linuxcnc.not-homed": Text(
        "Die Maschine von LinuxCNC unter {name} hat keine Referenzfahrt gemacht (Gelenke "
        "{joints:, }).",
        "Prüfen, dass der Tisch frei ist, dann „Referenzfahrt“ drücken oder alle Gelenke in "
        "LinuxCNC referenzieren.",
    ),
    "linuxcnc.not-secured": Text(
        "Das Werkzeug wurde nicht gehoben und die Stationen wurden nicht angehoben. {cause}",
        "{cause:hint}",
    ),
    "linuxcnc.program-not-opened": Text(
        "LinuxCNC unter {name} kann die Programmdatei {path} nicht öffnen. {cause}",
        "Läuft LinuxCNC auf einem anderen Rechner, einen gemeinsamen Ordner einrichten und seinen "
        "Pfad auf beiden Rechnern angeben: "
        "linuxcnc://HOST:PORT/?programs=ORDNER&remote=ORDNER_DORT. Der Benutzer von LinuxCNC muss "
        "ihn lesen können.",
    ),
    "linuxcnc.refused": Text(
        "LinuxCNC unter {name} hat den Befehl „{command}“ abgelehnt. {cause}",
        "Den Tisch und LinuxCNC prüfen, dann noch einmal versuchen.",
    ),
    "linuxcnc.rejected-in-check": Text(
        "LinuxCNC unter {name} hat das Programm abgelehnt, bevor sich etwas bewegt hat. {cause}",
        "Fehlt ein Werkzeug, die Werkzeugtabelle der Maschine (knifetip machine NAME "
        "--tool-table) nach LinuxCNC schreiben. Sonst den Auftrag für diese Steuerung neu "
        "berechnen.",
    ),
    "linuxcnc.silent": Text(
        "LinuxCNC unter {name} hat seit {seconds:g} s nicht geantwortet. Es führt sein Programm "
        "vielleicht weiter aus.",
        "Vom Tisch fernbleiben, bis die Maschine steht, oder den Not-Halt-Taster drücken. Dann "
        "prüfen, ob LinuxCNC und linuxcncrsh laufen.",
    ),
    "linuxcnc.stopped": Text(
        "LinuxCNC unter {name} hat nahe Programmzeile {line} einen Fehler gemeldet. {cause}",
        "Vor dem nächsten Auftrag den Tisch und den Karton prüfen.",
    ),
    "linuxcnc.unreadable": Text(
        "LinuxCNC unter {name} hat eine Antwort gesendet, die das Gateway nicht lesen kann: "
        "{reply}.",
        "Jede andere Verbindung zu linuxcncrsh schließen: Es verwechselt die Antworten an zwei "
        "Clients.",
    ),
    "linuxcnc.wrong-password": Text(
        "linuxcncrsh unter {name} hat das Passwort der Option {option} abgelehnt.",
        "Die Passwörter von linuxcncrsh in der Adresse angeben: "
        "linuxcnc://HOST:PORT/?password=CONNECTPW&enable=ENABLEPW.",
    ),
}
