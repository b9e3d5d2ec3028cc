"""database: German texts of the messages of ``catalogue.database``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "store.no-column": Text(
        "{kind:kind} {id}: {column} gibt es noch nicht.",
        "Warten, bis die Berechnung fertig ist. Ist sie fehlgeschlagen, zeigen die Felder state "
        "und reason den Grund.",
    ),
    "store.unknown": Text(
        "{kind:kind} {id} gibt es nicht.",
        "Eine Kennung wählen, die GET /api/{kind}s nennt.",
    ),
    "backup.exists": Text(
        "Die Datei {file} gibt es schon.",
        "Eine andere Datei wählen oder sie mit --replace ersetzen.",
    ),
    "backup.foreign": Text(
        "Die Datenbank in der Datei {file} enthält keine Tabellen von knifetip.",
        "Eine Datei wählen, die knifetip backup geschrieben hat.",
    ),
    "backup.missing-row": Text(
        "Die Datei {file} ist beschädigt: Eine Zeile der Tabelle {table} verweist auf eine "
        "fehlende Zeile.",
        "Eine andere Sicherung wählen.",
    ),
    "backup.not-a-backup": Text(
        "Die Datei {file} ist keine Sicherung einer Datenbank von knifetip: {reason}.",
        "Eine Datei wählen, die knifetip backup geschrieben hat.",
    ),
    "backup.postgresql": Text(
        "Die Datenbank {url} liegt auf einem PostgreSQL-Server, der eigene Befehle für "
        "Sicherungen hat.",
        "Sichern mit: pg_dump --format=custom --file=DATEI DATENBANK. In eine leere Datenbank "
        "wiederherstellen mit: pg_restore --exit-on-error --dbname=DATENBANK DATEI.",
    ),
    "backup.unwritable": Text(
        "Die Datenbank kann nicht nach {file} kopiert werden: {reason}.",
        "Platz auf der Festplatte schaffen oder einen anderen Ordner wählen. Die Datenbank wurde "
        "nicht geändert.",
    ),
    "database.bad-url": Text(
        "„{url}“ ist nicht die URL einer Datenbank.",
        "Die URL als sqlite:///DATEI oder postgresql://BENUTZER@HOST/NAME schreiben.",
    ),
    "database.damaged": Text(
        "Die Datenbank {file} ist beschädigt: {reason}.",
        "Den Server anhalten und eine Sicherung einsetzen: knifetip restore DATEI --replace. Bis "
        "dahin die älteren Sicherungen behalten. Die Festplatte prüfen.",
    ),
    "database.folder-unusable": Text(
        "Der Ordner {folder} der Datenbank kann nicht benutzt werden: {reason}.",
        "Mit --database sqlite:///DATEI einen anderen Ordner wählen oder diesem Benutzer dort das "
        "Schreiben erlauben.",
    ),
    "database.in-use": Text(
        "Die Datenbank {file} wird benutzt.",
        "Den Server und die Worker anhalten, die sie benutzen, dann noch einmal versuchen.",
    ),
    "database.missing": Text(
        "Die Datenbank {file} gibt es nicht.",
        "Die Datenbank mit --database sqlite:///DATEI angeben.",
    ),
    "database.newer": Text(
        "Die Datenbank {url} wurde von knifetip {writer} geschrieben (Stand {revision}). knifetip "
        "{version} kennt Stände bis {newest} und würde sie beschädigen.",
        "Jene oder eine neuere Version von knifetip verwenden. Für die Rückkehr zu Version "
        "{version} eine Sicherung von vor der Umstellung wiederherstellen.",
    ),
    "database.newer-unrecorded": Text(
        "Die Datenbank {url} hat den Stand {revision} eines neueren oder geänderten knifetip. "
        "knifetip {version} kennt Stände bis {newest} und würde sie beschädigen.",
        "Die Version von knifetip starten, die sie geschrieben hat. Für die Rückkehr zu Version "
        "{version} eine Sicherung von vor der Umstellung wiederherstellen.",
    ),
    "database.unreleased": Text(
        "Die Datenbank {url} hat den Stand {revision}, der älter ist als die erste "
        "Veröffentlichung. knifetip {version} stellt Datenbanken ab Stand {oldest} um.",
        "Die Version von knifetip starten, die sie geschrieben hat, und offene Aufträge mit "
        "dieser Version und einer neuen Datenbank noch einmal erteilen.",
    ),
    "database.not-utf8": Text(
        "Die Datenbank {url} hat die Kodierung {encoding}, die nicht alle Namen speichern kann.",
        "Sie mit UTF-8 anlegen: CREATE DATABASE knifetip ENCODING 'UTF8' TEMPLATE template0 "
        "LC_COLLATE 'C.UTF-8' LC_CTYPE 'C.UTF-8'.",
    ),
    "database.older": Text(
        "Die Datenbank {url} hat den Stand {revision}; knifetip {version} braucht Stand {newest}.",
        "Alle Server und Worker anhalten, eine Sicherung machen und ausführen: knifetip db "
        "upgrade. Oder einen Server mit --migrate starten.",
    ),
    "database.no-password": Text(
        "Die Datei {file} enthält kein Passwort für die Datenbank.",
        "Nur das Passwort in die Datei schreiben, in UTF-8.",
    ),
    "database.password-file": Text(
        "Das Passwort der Datenbank kann nicht aus {file} gelesen werden: {reason}.",
        "Eine Datei nennen, die nur das Passwort enthält und die dieser Benutzer lesen kann.",
    ),
    "database.unusable": Text(
        "Die Datenbank kann nicht benutzt werden: {reason}.",
        "Prüfen, ob ihre Datei, ihr Ordner und ihre Festplatte da sind und dieser Benutzer darauf "
        "schreiben darf, oder mit --database eine andere wählen.",
    ),
    "database.unreachable": Text(
        "Die Datenbank ist nicht erreichbar: {reason}",
        "Die URL der Datenbank prüfen und ob ihr Server läuft.",
    ),
    "database.in-memory": Text(
        "Der Server kann keine Datenbank im Arbeitsspeicher verwenden, weil beim Anhalten alle "
        "Aufträge verloren gingen.",
        "Eine Datenbankdatei verwenden: sqlite:///DATEI.",
    ),
}
