"""library: German texts of the messages of ``catalogue.library``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "library.bad-if-match": Text(
        "Der Header If-Match ist „{match}“, das ist keine Versionsnummer.",
        'Den ETag des Eintrags in If-Match senden, zum Beispiel "3".',
    ),
    "library.acting-text": Text(
        "{shelf:shelf} {name}: Das Feld {field} enthält ein unsichtbares Steuerzeichen: „{text}“.",
        "Den Text neu eingeben, ohne Steuerzeichen und Zeichen der Schreibrichtung.",
    ),
    "library.long-text": Text(
        "{shelf:shelf} {name}: Das Feld {field} ist länger als {limit} Zeichen: „{text}“.",
        "Höchstens {limit} Zeichen verwenden.",
    ),
    "library.bad-name": Text(
        "„{name}“ ist kein gültiger Name ({shelf:shelf}).",
        "Bis zu 64 Kleinbuchstaben, Ziffern, Binde- und Unterstriche verwenden. Andere Zeichen "
        "gehören in den Titel.",
    ),
    "library.changed-since": Text(
        "es wurde für Version {version} gemacht ({shelf:shelf} {name}), die neueste Version ist "
        "{newest}",
    ),
    "library.deleted": Text(
        "{shelf:shelf} {name} wurde gelöscht.",
        "Einen neuen Auftrag mit einem anderen Eintrag bestellen oder den Eintrag neu anlegen.",
    ),
    "library.deleted-since": Text(
        "es wurde für Version {version} gemacht ({shelf:shelf} {name}), die gelöscht wurde",
    ),
    "library.exists": Text(
        "{shelf:shelf} {name} gibt es schon, in Version {version}.",
        'Zum Ersetzen If-Match: "{version}" senden oder einen anderen Namen wählen.',
    ),
    "library.in-use": Text(
        "{shelf:shelf} {name} kann nicht gelöscht werden: {count:# nicht beendeter Auftrag "
        "benutzt|# nicht beendete Aufträge benutzen} den Eintrag, zum Beispiel {jobs:, }.",
        "Warten, bis diese Aufträge beendet sind, oder sie abbrechen. Dann den Eintrag löschen.",
    ),
    "library.invalid": Text(
        "{shelf:shelf} „{name}“ kann nicht verwendet werden: {faults:; }.",
        "{faults:hint} Die TOML-Datei berichtigen. Der Befehl knifetip schema {shelf} beschreibt "
        "alle Felder.",
    ),
    "library.large-integer": Text(
        "Eine ganze Zahl im Dokument hat mehr als 64 Bit.",
        "Die Zahl berichtigen oder mit Dezimalpunkt schreiben.",
    ),
    "library.nested-too-deep": Text(
        "{shelf:shelf} „{name}“: Die Tabellen sind zu tief verschachtelt.",
        "Nur die Felder schreiben, die knifetip schema {shelf} beschreibt.",
    ),
    "library.no-settings": Text(
        "Die Steuerung von {machine} hat keine Einstellungen, die knifetip kennt.",
        "Die Steuerung nach der Anleitung ihres Herstellers einrichten.",
    ),
    "library.not-an-object": Text(
        "{shelf:shelf} „{name}“: Das JSON-Dokument ist kein Objekt.",
        "Ein Objekt mit den Feldern senden, die GET /api/schemas/{shelf}s beschreibt.",
    ),
    "library.null-in-list": Text(
        "{shelf:shelf} „{name}“: Eine Liste enthält null.",
        "null aus der Liste entfernen oder durch einen Wert ersetzen.",
    ),
    "library.not-json": Text(
        "{shelf:shelf} „{name}“ ist kein gültiges JSON: {reason}.",
        "Ein Objekt mit den Feldern senden, die GET /api/schemas/{shelf}s beschreibt.",
    ),
    "library.not-stored": Text(
        "Der Server hat keinen eigenen Eintrag {name} ({shelf:shelf}).",
        "Einen Eintrag wählen, den GET /api/library mit shipped: false nennt.",
    ),
    "library.not-toml": Text(
        "{shelf:shelf} „{name}“ ist kein gültiges TOML: {reason}.",
        "Die TOML-Syntax an dieser Stelle berichtigen.",
    ),
    "library.not-utf8": Text(
        "{shelf:shelf} „{name}“ ist kein UTF-8-Text: Byte {byte} ist ungültig.",
        "Die Datei als UTF-8 speichern.",
    ),
    "library.shipped": Text(
        "{shelf:shelf} „{name}“ ist Teil von knifetip und kann nicht geändert werden.",
        "Eine Kopie unter anderem Namen speichern und die Kopie ändern.",
    ),
    "library.stale": Text(
        "Ein anderer Benutzer hat {shelf:shelf} {name} geändert: Der Eintrag hat jetzt Version "
        "{version}, Ihre Änderung beruht auf Version {given}.",
        'Den Eintrag noch einmal laden und prüfen. Dann die Änderung mit If-Match: "{version}" '
        "senden.",
    ),
    "library.too-long": Text(
        "{shelf:shelf} „{name}“ ist {size} kB groß, erlaubt sind {limit} kB.",
        "Nicht benötigte Kommentare und Felder entfernen.",
    ),
    "library.too-many": Text(
        "Der Server hat schon {limit} eigene Maschinen, Materialien und Werkzeuge, mehr sind "
        "nicht erlaubt.",
        "Nicht benutzte Einträge löschen.",
    ),
    "library.unknown": Text(
        "{shelf:shelf} „{name}“ gibt es nicht.",
        "Eines von {known:, } wählen.",
    ),
    "library.unknown-file": Text(
        "{shelf:shelf} „{name}“ gibt es nicht: {reason}.",
        "Den Pfad der Datei prüfen oder eines von {known:, } wählen.",
    ),
    "library.unknown-version": Text(
        "{shelf:shelf} {name} hat keine Version {version}; die neueste ist {newest}.",
        "Eine der Versionen wählen, die GET /api/{shelf}s/{name}/versions nennt.",
    ),
    "library.unreadable": Text(
        "{shelf:shelf} „{name}“ kann nicht gelesen werden: {detail}.",
        "Die TOML-Datei berichtigen.",
    ),
    "profile.invalid-field": Text(
        "Das Profil kann nicht gelesen werden: {fault}.",
        "Die erwarteten Felder stehen unter ProfileIn in /api/openapi.json.",
    ),
    "profile.nested-too-deep": Text(
        "Die Tabellen des Profils „{name}“ sind zu tief verschachtelt.",
        "Nur einen Titel und eine Liste von Tabellen [[rule]] schreiben.",
    ),
    "profile.not-an-extension": Text(
        "Das Profil „{name}“ kann nicht als Erweiterung von „{extends}“ gespeichert werden, weil "
        "ihm Regeln von „{extends}“ fehlen.",
        "Das Profil ohne das Feld extends speichern.",
    ),
    "profile.not-kept": Text(
        "Der Server hat kein eigenes Profil mit dem Namen {name}.",
        "Eines der Profile wählen, die GET /api/profiles nennt.",
    ),
    "profile.not-toml": Text(
        "Das Profil „{name}“ ist kein gültiges TOML: {reason}.",
        "Die TOML-Syntax an dieser Stelle berichtigen.",
    ),
    "profile.not-utf8": Text(
        "Die Datei {name} ist kein UTF-8-Text.",
        "Die Datei als UTF-8 speichern.",
    ),
    "profile.too-long": Text(
        "Das Profil „{name}“ ist {size} kB groß, erlaubt sind {limit} kB.",
        "Regeln des Profils zusammenfassen: Eine Regel kann viele Layer nennen, und * steht für "
        "beliebige Zeichen.",
    ),
    "profile.too-many": Text(
        "Der Server hat schon {limit} Profile, mehr sind nicht erlaubt.",
        "Ein nicht benutztes Profil löschen.",
    ),
    "rule.block": Text(
        "im Block {patterns:or}",
    ),
    "rule.colour": Text(
        "Farbe {colours:or}",
    ),
    "rule.conditions": Text(
        "{conditions:, }",
    ),
    "rule.entity": Text(
        "Objektart {kinds:or}",
    ),
    "rule.everything": Text(
        "jede Kante der Zeichnung",
    ),
    "rule.layer": Text(
        "Layer {patterns:or}",
    ),
    "rule.linetype": Text(
        "Strichart {patterns:or}",
    ),
}
