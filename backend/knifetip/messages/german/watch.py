"""watch: German texts of the messages of ``catalogue.watch``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "watch.bad-sidecar": Text(
        "Die Datei mit den Feldern der Bestellung kann nicht gelesen werden: {reason}.",
        "Ein JSON-Objekt mit den Feldern einer Bestellung schreiben, etwa board und copies.",
    ),
    "watch.folder": Text(
        "Der Ordner {folder} kann nicht benutzt werden: {reason}.",
        "Einen vorhandenen Ordner mit Lese- und Schreibrecht wählen.",
    ),
    "watch.large-sidecar": Text(
        "Die Datei mit den Feldern der Bestellung ist größer als {limit} MB.",
        "Nur die Felder der Bestellung hineinschreiben.",
    ),
    "watch.xjdf-fields": Text(
        "Die JSON-Datei der XJDF-Bestellung enthält {names:, }. Diese Felder bestimmt das "
        "XJDF-Dokument.",
        "Diese Felder entfernen. Nur {permitted:or} darf in der Datei stehen.",
    ),
    "watch.no-drawing": Text(
        "Die Zeichnung {name} der Bestellung ist nicht im Ordner angekommen.",
        "Die Zeichnung in den Ordner legen, dann die Bestellung noch einmal. Oder beides in ein "
        "Paket *.xjdf.zip legen.",
    ),
    "watch.no-object": Text(
        "Die Datei mit den Feldern der Bestellung ist kein JSON-Objekt.",
        "Ein JSON-Objekt mit den Feldern einer Bestellung schreiben, etwa board und copies.",
    ),
    "watch.other-drawing": Text(
        "Die Datei mit den Feldern der Bestellung enthält das Feld drawing, aber die Bestellung "
        "gilt für die Zeichnung neben ihr.",
        "Das Feld drawing entfernen.",
    ),
    "watch.taken": Text(
        "Ein anderer Prozess überwacht den Ordner {folder} schon.",
        "Den anderen Prozess beenden oder einen anderen Ordner überwachen.",
    ),
}
