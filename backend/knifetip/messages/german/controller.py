"""controller: German texts of the messages of ``catalogue.controller``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "controller.alarm": Text(
        "{name} hat mit ALARM:{code} angehalten: {alarm}. {due}",
        "Den Tisch prüfen und vor dem nächsten Auftrag eine Referenzfahrt machen ($H).",
    ),
    "controller.alarm-code": Text(
        "ALARM:{code} ({alarm})",
    ),
    "controller.alarm-of-unknown-cause": Text(
        "{name} ist durch einen Alarm gesperrt, dessen Code nicht angekommen ist.",
        "Den Tisch prüfen, dann eine Referenzfahrt machen. Hat die Maschine keine Endschalter, "
        "sie entsperren.",
    ),
    "controller.alarm-state": Text(
        "{name} hat angehalten und meldet einen Alarm. {due}",
        "Den Tisch prüfen, dann eine Referenzfahrt machen ($H) oder entsperren ($X).",
    ),
    "controller.alarm-unknown": Text(
        "ein unbekannter Alarm",
    ),
    "controller.answer-lost": Text(
        "{name} ist seit {seconds:g} s im Zustand {state}. Eine Antwort der Steuerung ist also "
        "verloren gegangen. {due}",
        "Das Kabel zur Steuerung prüfen, dann den Karton auf dem Tisch prüfen.",
    ),
    "controller.answer-missing": Text(
        "Der Empfangspuffer von {name} enthält weniger Bytes, als gesendet wurden. Eine Antwort "
        "der Steuerung oder Bytes auf dem Weg zu ihr sind also verloren gegangen. {due}",
        "Das Kabel zur Steuerung prüfen, dann den Karton auf dem Tisch prüfen.",
    ),
    "controller.bad-address": Text(
        "„{address}“ ist nicht die Adresse einer Steuerung.",
        "Die Adresse als HOST:PORT schreiben, zum Beispiel 127.0.0.1:2323, oder als URL. Bekannte "
        "Schemata: {schemes:, }.",
    ),
    "controller.bad-host": Text(
        "Die Adresse „{address}“ der Steuerung kann nicht stimmen: „{host}“ ist weder eine "
        "IP-Adresse noch ein Hostname.",
        "Die Adresse als HOST:PORT schreiben, zum Beispiel 127.0.0.1:2323.",
    ),
    "controller.bad-serial-address": Text(
        "„{address}“ ist nicht die Adresse einer seriellen Schnittstelle.",
        "Als serial:///dev/ttyUSB0 oder serial://COM3 schreiben; ?baud=250000 am Ende setzt eine "
        "andere Geschwindigkeit als 115200 Bit je Sekunde, &flow=rtscts oder &flow=xonxoff die "
        "Flusssteuerung.",
    ),
    "controller.busy": Text(
        "{name} ist beschäftigt: Sie meldet den Zustand {state}. Nichts wurde gesendet.",
        "Warten, bis die Steuerung frei ist, oder sie am Tisch zurücksetzen.",
    ),
    "controller.check-end-not-confirmed": Text(
        "{name} hat nicht innerhalb von {seconds:g} s bestätigt, dass der Prüfbetrieb ($C), in "
        "dem sich nichts bewegt, beendet ist.",
        "Den Tisch prüfen, dann noch einmal versuchen.",
    ),
    "controller.closed": Text(
        "Die Verbindung zu {name} wurde geschlossen.",
        "Die Verbindung zur Steuerung neu herstellen.",
    ),
    "controller.connection-failed": Text(
        "Die Verbindung zu {address} ist verloren ({reason}).",
        "Den Tisch prüfen, bevor wieder etwas gesendet wird.",
    ),
    "controller.due": Text(
        "Auf Programmzeile {line} ({text}) kam keine Antwort.",
    ),
    "controller.in-alarm": Text(
        "{name} ist durch Alarm {code} gesperrt: {alarm}.",
        "{alarm:hint}",
    ),
    "controller.lift-not-finished": Text(
        "{name} hat das Werkzeug nicht innerhalb von {seconds:g} s gehoben.",
        "Am Tisch das Werkzeug heben und die Stationen anheben.",
    ),
    "controller.line-changed": Text(
        "{name} hat „{received}“ statt Programmzeile {line} ({sent}) empfangen.",
        "Das Kabel zur Steuerung prüfen. Den Karton auf dem Tisch prüfen, er kann verdorben sein.",
    ),
    "controller.locked": Text(
        "{name} ist durch {cause} gesperrt. Die Stationen sind vielleicht noch unten.",
        "Am Tisch das Werkzeug heben und die Stationen anheben, dann eine Referenzfahrt machen "
        "($H) oder entsperren ($X).",
    ),
    "controller.locked-by-alarm": Text(
        "{name} ist durch einen Alarm gesperrt.",
        "Am Tisch eine Referenzfahrt machen ($H) oder entsperren ($X).",
    ),
    "controller.left-program": Text(
        "{name} führt das Programm nicht mehr aus: Der Zustand ist {state}.",
        "Den Tisch prüfen. Ein anderes Programm oder eine Person hat die Maschine vielleicht "
        "bedient.",
    ),
    "controller.lost": Text(
        "Die Verbindung zu {name} ist verloren. {due}",
        "Das Kabel zur Steuerung prüfen, dann den Karton auf dem Tisch prüfen.",
    ),
    "controller.lost-in-buffer": Text(
        "Die Verbindung zu {name} ist verloren. Die Steuerung führt vielleicht noch die "
        "Programmzeilen in ihrem Puffer aus.",
        "Vom Tisch fernbleiben, bis die Maschine steht, dann den Tisch prüfen.",
    ),
    "controller.no-host-and-port": Text(
        "Die Adresse „{address}“ der Steuerung hat keinen Host oder keinen Port.",
        "Die Adresse als HOST:PORT schreiben, zum Beispiel 127.0.0.1:2323.",
    ),
    "controller.not-ready": Text(
        "{name} ist nicht bereit: Sie meldet den Zustand {state}. Nichts wurde gesendet.",
        "Warten, bis die Steuerung frei ist, oder sie entsperren, dann den Auftrag noch einmal "
        "senden.",
    ),
    "controller.door-open": Text(
        "{name} hat das Werkzeug und die Stationen nicht gehoben, weil die Schutztür offen ist.",
        "Die Schutztür schließen, „Freigeben“ drücken, dann das Werkzeug heben.",
    ),
    "controller.not-recovered": Text(
        "{name} hat den sicheren Zustand mit gehobenem Werkzeug und angehobenen Stationen nicht "
        "erreicht.",
        "Am Tisch das Werkzeug heben und die Stationen anheben.",
    ),
    "controller.not-secured": Text(
        "{name} kann nicht in den sicheren Zustand mit gehobenem Werkzeug und angehobenen "
        "Stationen gebracht werden, weil der Zustand {state} gemeldet wird.",
        "Am Tisch das Werkzeug heben und die Stationen anheben.",
    ),
    "controller.not-stopped": Text(
        "{error} {progress} Die Maschine ist nicht in einem sicheren Zustand: {unsafe}",
        "{unsafe:hint}",
    ),
    "controller.off-heading": Text(
        "Bei X{x:.3f} Y{y:.3f} mm war das Werkzeug auf C{c:.3f} gedreht, {turn:.1f} Grad neben "
        "dem Programm nahe Programmzeile {line}. Entweder wurde eine Programmzeile auf dem Weg "
        "zur Steuerung verfälscht, oder ein Motor hat Schritte verloren.",
        "Das Kabel zur Steuerung prüfen und eine Referenzfahrt machen. Den Karton auf dem Tisch "
        "prüfen, er kann verdorben sein.",
    ),
    "controller.off-path": Text(
        "Die Maschine war bei X{x:.3f} Y{y:.3f} Z{z:.3f} mm, {distance:.1f} mm neben der Bahn des "
        "Programms nahe Programmzeile {line}. Entweder wurde eine Programmzeile auf dem Weg zur "
        "Steuerung verfälscht, oder ein Motor hat Schritte verloren.",
        "Das Kabel zur Steuerung prüfen und eine Referenzfahrt machen. Den Karton auf dem Tisch "
        "prüfen, er kann verdorben sein.",
    ),
    "controller.port-busy": Text(
        "Ein anderes Programm benutzt die serielle Schnittstelle {port}.",
        "Das andere Programm schließen, dann das Gateway neu starten.",
    ),
    "controller.port-missing": Text(
        "Es gibt keine serielle Schnittstelle {port}. {found}",
        "Die Steuerung anstecken und einschalten oder den Namen der Schnittstelle berichtigen.",
    ),
    "controller.port-not-permitted": Text(
        "Der Benutzer dieses Gateways darf die serielle Schnittstelle {port} nicht öffnen.",
        "Unter Linux den Benutzer in die Gruppe der Schnittstelle aufnehmen, meist dialout (sudo "
        "usermod -aG dialout BENUTZER), dann neu anmelden.",
    ),
    "controller.port-unusable": Text(
        "Die serielle Schnittstelle {port} kann nicht geöffnet werden ({reason}).",
        "Den Namen der Schnittstelle oder ihre Geschwindigkeit berichtigen.",
    ),
    "controller.ports-found": Text(
        "Dieser Rechner hat die Schnittstellen {ports:, }.",
    ),
    "controller.refused-safe-state": Text(
        "{refusals: }",
        "Am Tisch das Werkzeug heben und die Stationen anheben. Dann die Ausgänge in der "
        "Maschinendatei mit denen der Steuerung vergleichen.",
    ),
    "controller.one-carriage": Text(
        "Die Maschine {machine} hat {count} Schlitten, und das Gateway und der simulierte Tisch "
        "können nur eine Maschine mit einem steuern.",
        "Das Programm herunterladen und in der Steuerung der Maschine öffnen.",
    ),
    "controller.rejected-command": Text(
        "{name} hat den Befehl {command} abgelehnt: {error} (error:{code}).",
        "Den Tisch prüfen, dann noch einmal versuchen.",
    ),
    "controller.rejected-in-check": Text(
        "{name} hat Programmzeile {line} ({text}) im Prüfbetrieb abgelehnt, bevor sich etwas "
        "bewegt hat: {error} (error:{code}).",
        "Den Auftrag für diese Steuerung neu berechnen.",
    ),
    "controller.rejected-line": Text(
        "{name} hat Programmzeile {line} ({text}) abgelehnt: {error} (error:{code}).",
        "Den Karton auf dem Tisch prüfen, dann den Auftrag für diese Steuerung neu berechnen.",
    ),
    "controller.reports-alarm": Text(
        "{name} meldet einen Alarm.",
        "Den Tisch prüfen, dann eine Referenzfahrt machen ($H) oder entsperren ($X).",
    ),
    "controller.reset": Text(
        "{name} wurde zurückgesetzt. Die Position der Maschine ist vielleicht verloren, also "
        "läuft der Auftrag nicht von selbst weiter. {due}",
        "Den Tisch prüfen und eine Referenzfahrt machen. Dann den Auftrag noch einmal einreihen "
        "oder verwerfen.",
    ),
    "controller.reset-not-confirmed": Text(
        "{name} hat das Zurücksetzen nicht innerhalb von {seconds:g} s bestätigt.",
        "Den Tisch prüfen, dann noch einmal versuchen.",
    ),
    "controller.settings-refused": Text(
        "{name} hat Einstellungen, mit denen die Programme dieser Maschine gefährlich wären: "
        "{differences: } Nichts wurde gesendet.",
        "{differences:hint} Das Gateway verbindet sich dann von selbst.",
    ),
    "controller.silent": Text(
        "{name} hat seit {seconds:g} s nicht geantwortet. {due}",
        "Das Kabel zur Steuerung prüfen, dann den Karton auf dem Tisch prüfen.",
    ),
    "controller.stopped": Text(
        "{error} {progress} Die Maschine wurde angehalten, der Kopf auf Z {height:.1f} mm "
        "gehoben, und die Stationen wurden angehoben.",
        "{error:hint}",
    ),
    "controller.unsafe": Text(
        "{error} {progress} Die Maschine ist nicht in einem sicheren Zustand: Die Stationen sind "
        "vielleicht noch unten.",
        "Am Tisch das Werkzeug heben und die Stationen anheben. {error:hint}",
    ),
    "controller.unable": Text(
        "{name} kann Programmzeile {line} ({text}) nicht ausführen: {obstacle}. Nichts hat sich "
        "bewegt.",
        "Eine Steuerung mit den Achsen und Ausgängen der Maschine verwenden, zum Beispiel "
        "grblHAL, oder die Maschinendatei berichtigen.",
    ),
    "controller.too-few-outputs": Text(
        "{name} hat {count:# digitalen Ausgang|# digitale Ausgänge}, aber die Maschinendatei "
        "enthält eine Station mit Ausgang {output}. Nichts wurde gesendet.",
        "Eine Steuerung mit mehr Ausgängen verwenden, zum Beispiel grblHAL, oder die "
        "Maschinendatei berichtigen.",
    ),
    "controller.unexpected-answer": Text(
        "{name} hat auf eine Programmzeile geantwortet, die dieses Gateway nicht gesendet hat. "
        "Entweder wurde eine Antwort doppelt gesendet, oder ein anderes Programm sendet Zeilen an "
        "die Steuerung.",
        "Das Kabel zur Steuerung prüfen und jedes andere Programm schließen, das mit der "
        "Steuerung verbunden ist.",
    ),
    "controller.unreachable": Text(
        "Unter {address} antwortet keine Steuerung ({reason}).",
        "Die Steuerung einschalten oder die Adresse berichtigen.",
    ),
    "controller.was-reset": Text(
        "{name} wurde zurückgesetzt.",
        "Den Tisch prüfen und vor dem nächsten Auftrag eine Referenzfahrt machen.",
    ),
    "controller.web-server": Text(
        "Unter {address} antwortet ein Webserver, keine Steuerung.",
        "Host oder Port in der Adresse der Steuerung berichtigen.",
    ),
    "folder.bad-address": Text(
        "„{address}“ ist nicht die Adresse eines Ordners auf diesem Rechner.",
        "Als file:///ORDNER mit dem vollen Pfad des Ordners schreiben, zum Beispiel "
        "file:///srv/programs.",
    ),
    "folder.deleted": Text(
        "Die Programmdatei {file} war noch im Ordner und wurde gelöscht. Die Software der "
        "Maschine hat sie vielleicht vorher gelesen.",
        "An der Maschine prüfen, dass das Programm nicht geladen ist. Läuft es, es dort anhalten.",
    ),
    "folder.not-deleted": Text(
        "Die Programmdatei {file} konnte nicht gelöscht werden ({reason}).",
        "Die Datei löschen. An der Maschine prüfen, dass das Programm nicht geladen ist.",
    ),
    "folder.not-written": Text(
        "Das Programm wurde nicht in den Ordner {folder} geschrieben, die Maschine hat es also "
        "nicht bekommen.",
        "Den Ordner prüfen, dann den Auftrag noch einmal einreihen.",
    ),
    "folder.taken": Text(
        "Die Software der Maschine hat die Programmdatei {file} genommen, die Maschine führt sie "
        "also vielleicht aus.",
        "Das Programm an der Maschine anhalten. Von hier aus kann nichts angehalten werden.",
    ),
    "folder.unusable": Text(
        "In den Ordner {folder} können keine Programme geschrieben werden ({reason}).",
        "Den Ordner anlegen oder dem Benutzer des Gateways das Schreiben darin erlauben.",
    ),
    "run.executed": Text(
        "{executed} von {lines} Programmzeilen wurden ausgeführt.",
    ),
    "run.in-buffer": Text(
        "{executed} von {lines} Programmzeilen wurden ausgeführt. Bis zu {rest} weitere "
        "Programmzeilen, die im Puffer der Steuerung waren, können auch ausgeführt worden sein.",
    ),
    "run.nothing-sent": Text(
        "Keine Programmzeile wurde ausgeführt.",
    ),
}
