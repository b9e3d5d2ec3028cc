"""server: German texts of the messages of ``catalogue.server``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "process.name-taken": Text(
        "Ein anderer Prozess mit dem Namen {name} benutzt diese Datenbank schon.",
        "Jedem Prozess mit --name einen eigenen Namen geben oder den anderen Prozess anhalten.",
    ),
    "server.bad-metrics-address": Text(
        "„{address}“ ist kein gültiger Wert für --metrics-address.",
        "Als HOST:PORT schreiben, etwa 127.0.0.1:9464 oder [::1]:9464.",
    ),
    "server.address-in-use": Text(
        "Der Server kann die Adresse {host}:{port} nicht benutzen: {reason}.",
        "Das Programm anhalten, das den Port benutzt, oder mit --port einen anderen wählen.",
    ),
    "server.answered": Text(
        "Die Anfrage an {url} ist mit dem HTTP-Status {status} fehlgeschlagen.",
        "Die Adresse prüfen. Das Protokoll des Servers enthält die Ursache.",
    ),
    "server.busy": Text(
        "Der Server ist ausgelastet: {waiting:# Anfrage wartet|# Anfragen warten} schon, also "
        "wurde diese nicht begonnen.",
        "Die Anfrage in {seconds} s noch einmal senden.",
    ),
    "server.database-damaged": Text(
        "Die Datenbank des Servers ist beschädigt.",
        "Den Server anhalten und eine Sicherung einsetzen: knifetip restore DATEI --replace. Die "
        "Festplatte prüfen. Ein neuer Versuch hilft nicht.",
    ),
    "server.database-silent": Text(
        "Die Datenbank des Servers antwortet nicht.",
        "Gleich noch einmal versuchen. Geschieht es wieder, die Datenbank prüfen.",
    ),
    "server.internal-error": Text(
        "Interner Fehler des Servers. Nichts wurde geschnitten.",
        "Den Fehler mit dem Protokoll des Servers melden.",
    ),
    "server.machine-taken": Text(
        "Ein anderer Server ({holder}) betreibt die simulierte Maschine {machine} dieser Datenbank "
        "schon.",
        "Jenen Server anhalten, ein anderes --database verwenden, oder diesen Server mit "
        "--no-simulator starten.",
    ),
    "server.not-started": Text(
        "Der Server konnte mit der Datenbank {database} nicht starten.",
        "Die Ursache beheben, die die Zeilen über dieser Meldung nennen.",
    ),
    "server.stopping": Text(
        "Der Server wird beendet und nimmt keine neuen Anfragen an.",
        "Gleich noch einmal versuchen.",
    ),
    "server.unreachable": Text(
        "Der Server {server} ist nicht erreichbar: {reason}.",
        "Die Adresse in --server und die Netzwerkverbindung prüfen.",
    ),
    "request.body-too-large": Text(
        "Die Anfrage ist größer als {limit} MB, die Grenze für diese URL.",
        "Die Daten auf mehrere Anfragen verteilen.",
    ),
    "request.body-unreadable": Text(
        "Der Inhalt der Anfrage kann nicht gelesen werden.",
        "JSON oder multipart/form-data senden, wie /api/openapi.json beschreibt, mit dem "
        "passenden Content-Type.",
    ),
    "request.foreign-origin": Text(
        "Die Anfrage wurde abgelehnt, weil die Seite einer anderen Website sie gesendet hat.",
        "Die Anfrage von der Seite dieses Servers senden oder von einem Programm, das kein "
        "Browser ist.",
    ),
    "request.foreign-page": Text(
        "Die Anfrage wurde abgelehnt, weil die Seite einer anderen Website ({origin}) sie "
        "gesendet hat.",
        "Die Anfrage von der Seite dieses Servers senden oder von einem Programm, das kein "
        "Browser ist.",
    ),
    "request.html-form": Text(
        "Die Schnittstelle nimmt keine Daten vom Typ {media} an.",
        "JSON mit Content-Type: application/json senden.",
    ),
    "request.invalid": Text(
        "Die Anfrage ist ungültig: {faults:; }.",
        "{faults:hint} Diese Felder der Anfrage berichtigen. /api/openapi.json beschreibt alle "
        "Felder.",
    ),
    "request.key-needed": Text(
        "Diese Anfrage braucht den Zugangsschlüssel des Servers.",
        "Den Zugangsschlüssel im Header Authorization: Bearer SCHLÜSSEL senden oder auf der Seite "
        "des Servers anmelden.",
    ),
    "request.key-reused": Text(
        "Der Idempotency-Key {key} wurde schon für eine andere Anfrage verwendet.",
        "Für jede neue Anfrage einen neuen verwenden.",
    ),
    "request.local-only": Text(
        "Dieser Server hat keinen Zugangsschlüssel, also nimmt er nur Anfragen vom eigenen "
        "Rechner an.",
        "Den Server mit --key-file PFAD oder --key SCHLÜSSEL starten, oder die Seite des Servers "
        "auf demselben Rechner unter http://localhost öffnen.",
    ),
    "request.no-host": Text(
        "Die Anfrage hat nicht genau einen Header Host.",
        "Einen Header Host senden, wie HTTP/1.1 es verlangt.",
    ),
    "request.not-base64": Text(
        "Der Inhalt der Datei {name} ist nicht base64.",
        "Die Bytes der Datei in base64 kodieren, ohne Zeilenumbrüche.",
    ),
    "request.one-drawing": Text(
        "Eine Bestellung braucht genau eines von Datei, Kennung einer gespeicherten Zeichnung, "
        "Schachtelform und Layout.",
        "Die Datei senden (Formularteil oder JSON-Feld file) oder das Feld drawing, carton oder "
        "layout.",
    ),
    "request.not-marked": Text(
        "Der Anfrage fehlt der Header X-Knifetip, der den Server vor Anfragen anderer Websites "
        "schützt.",
        "Den Header X-Knifetip mit beliebigem Wert senden.",
    ),
    "request.order-not-tried": Text(
        "Diese Bestellung wurde nicht bearbeitet, weil eine davor fehlgeschlagen ist. {reason}",
        "Die Anfrage mit demselben Idempotency-Key noch einmal senden: Was gespeichert ist, wird "
        "nicht doppelt bestellt.",
    ),
    "request.not-storable": Text(
        "Die Anfrage enthält Zeichen oder Zahlen, die die Datenbank nicht speichern kann.",
        "Steuerzeichen entfernen und endliche Zahlen verwenden.",
    ),
    "request.outcome-unknown": Text(
        "Eine frühere Anfrage mit diesem Idempotency-Key wurde begonnen, aber es ist nicht "
        "bekannt, ob sie ausgeführt wurde.",
        "Nachsehen, ob sie ausgeführt wurde. Wenn nicht, die Anfrage mit einem neuen Schlüssel "
        "noch einmal senden.",
    ),
    "request.secret-not-kept": Text(
        "Eine Anfrage mit diesem Idempotency-Key wurde schon ausgeführt. Ihre Antwort enthielt ein "
        "Geheimnis, das der Server nicht speichert, also kann die Antwort nicht wiederholt werden: "
        "siehe {path}.",
        "Mit POST {path}/rotate-secret ein neues Geheimnis holen.",
    ),
    "request.wrong-media": Text(
        "Der Content-Type {media} wird hier nicht unterstützt.",
        "Den Inhalt als {supported:or} senden und dies im Header Content-Type nennen.",
    ),
    "request.no-media": Text(
        "Die Anfrage hat einen Inhalt, aber keinen Content-Type.",
        "Den Inhalt als {supported:or} senden und dies im Header Content-Type nennen.",
    ),
    "request.nothing-there": Text(
        "Die URL {path} gibt es auf diesem Server nicht.",
        "Eine URL wählen, die /api/openapi.json beschreibt.",
    ),
    "request.refused": Text(
        "Die Anfrage wurde mit dem HTTP-Status {status} abgelehnt.",
        "Die Anfrage berichtigen, wie /api/openapi.json beschreibt.",
    ),
    "request.scope-missing": Text(
        "{principal} fehlt die Berechtigung {scope}, die diese Anfrage braucht (vorhanden: "
        "{scopes:, }).",
        "Als Benutzer mit der Rolle {scope} anmelden oder einen API-Schlüssel mit dieser "
        "Berechtigung verwenden.",
    ),
    "request.unknown-zone": Text(
        "„{zone}“ ist nicht der Name einer Zeitzone.",
        "Einen Namen der IANA-Zeitzonendatenbank verwenden, etwa Europe/Berlin oder UTC.",
    ),
    "request.upload-too-large": Text(
        "Die Datei ist größer als {limit} MB, die Grenze dieses Servers.",
        "Eine kleinere Datei senden, zum Beispiel ohne Bilder.",
    ),
    "request.wrong-host": Text(
        "Dieser Server nimmt keine Anfragen für den Host „{host}“ an.",
        "Die IP-Adresse des Servers verwenden oder den Server mit --allow-host {host} starten.",
    ),
    "request.wrong-key": Text(
        "Der Zugangsschlüssel der Anfrage ist falsch.",
        "Den Schlüssel dieses Servers im Header Authorization: Bearer SCHLÜSSEL senden.",
    ),
    "request.wrong-method": Text(
        "Die Methode {method} wird bei {path} nicht unterstützt.",
        "Eine Methode wählen, die /api/openapi.json für diese URL beschreibt.",
    ),
    "settings.bad-file": Text(
        "Die Datei {file} mit Einstellungen kann nicht benutzt werden: {reason}.",
        "Die Datei berichtigen oder den Server ohne sie starten.",
    ),
    "settings.bad-host": Text(
        "„{host}“ ist kein Hostname.",
        "Den Host als NAME oder NAME:PORT schreiben.",
    ),
    "settings.bad-key": Text(
        "{what} hat {length} Zeichen, muss aber {shortest} bis 200 ASCII-Zeichen ohne Leerzeichen "
        "haben.",
        "Einen anderen Schlüssel wählen oder --key-file PFAD einen erzeugen lassen.",
    ),
    "settings.invalid": Text(
        "Die Einstellungen können nicht benutzt werden: {faults:; }.",
        "{faults:hint} Die Seite „Settings“ der Dokumentation nennt alle Einstellungen.",
    ),
    "settings.key-file": Text(
        "Die Schlüsseldatei {file} kann nicht benutzt werden: {reason}.",
        "Eine Datei wählen, die der Server lesen und schreiben kann.",
    ),
    "settings.two-keys": Text(
        "Der Server wurde mit --key und mit --key-file gestartet.",
        "Nur eine der beiden Optionen angeben.",
    ),
    "command.bad-corner": Text(
        "Die Option --corner-at „{text}“ hat nicht die Form X,Y=TYP oder X,Y=TYP:K.",
        "Zum Beispiel --corner-at 300,100=C oder --corner-at 300,100=D:0.3 schreiben.",
    ),
    "command.bad-mark": Text(
        "Die Option --mark „{text}“ hat nicht die Form X,Y oder X,Y=X,Y.",
        "Zum Beispiel --mark 5,5 schreiben oder, für eine gemessene Marke, --mark 5,5=31.2,24.8.",
    ),
    "command.bad-option": Text(
        "Die Option {option} kann nicht verwendet werden: {faults:; }.",
        "{faults:hint} knifetip program --help beschreibt alle Optionen.",
    ),
    "command.bad-edge": Text(
        "Die Option --edge „{pair}“ hat nicht die Form KANTE=ART oder KANTE,KANTE=ART.",
        "Zum Beispiel --edge 12,13=ignored schreiben. Die erste Kante hat die Nummer 0.",
    ),
    "command.bad-layer": Text(
        "Die Option --layer „{pair}“ hat nicht die Form NAME=ART.",
        "Zum Beispiel --layer FOLDS=crease schreiben.",
    ),
    "command.bad-line-type": Text(
        "Die Linienart in der Option „{pair}“ gibt es nicht.",
        "Die Linienart {known:or} wählen.",
    ),
    "command.file-too-large": Text(
        "Die Datei {path} ist größer als {limit} MB.",
        "Eine einzelne Schachtel exportieren, ohne Bilder.",
    ),
    "command.no-such-layer": Text(
        "Die Datei {file} hat keinen Layer „{layer}“.",
        "Einen der Layer der Datei wählen: {layers:, }.",
    ),
    "command.unreadable-file": Text(
        "Die Datei {path} kann nicht gelesen werden: {reason}.",
        "Den Namen und die Rechte der Datei prüfen.",
    ),
    "command.unwritable-file": Text(
        "Die Datei {path} kann nicht geschrieben werden: {reason}.",
        "Einen anderen Pfad wählen.",
    ),
}
