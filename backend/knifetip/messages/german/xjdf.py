"""xjdf: German texts of the messages of ``catalogue.xjdf``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "xjdf.unreadable": Text(
        "Das Dokument ist nicht als XML lesbar: {reason}.",
        "Ein XJDF- oder XJMF-Dokument ohne Dokumenttyp-Deklaration senden.",
    ),
    "xjdf.not-xjdf": Text(
        "Das Wurzelelement des Dokuments ist {element}.",
        "Ein Element {wanted} aus dem Namensraum {namespace} senden.",
    ),
    "xjdf.missing": Text(
        "In der XJDF-Bestellung fehlt {place}.",
        "{place} im Dokument ergänzen. Maschine und Material können auch Parameter der Anfrage "
        "sein.",
    ),
    "xjdf.twice": Text(
        "Die XJDF-Bestellung enthält mehrere Werte von {place}.",
        "Für jeden Wert eine eigene Bestellung senden.",
    ),
    "xjdf.bad-value": Text(
        "{place} hat den Wert „{value}“, der nicht unterstützt wird.",
        "Einen der Werte verwenden, die die Anleitung order-with-xjdf beschreibt.",
    ),
    "xjdf.foreign-drawing": Text(
        "Die Zeichnung {url} liegt auf einem anderen Server als {host} und wird von dort nicht "
        "geholt.",
        "Die Zeichnung im Paket senden oder auf diesen Server hochladen und ihren Pfad nennen.",
    ),
    "xjdf.bad-name": Text(
        "Das Paket enthält eine Datei mit dem unsicheren Namen „{name}“.",
        "Relative Namen ohne .., umgekehrte Schrägstriche, Doppelpunkte und Steuerzeichen "
        "verwenden.",
    ),
    "xjdf.bad-package": Text(
        "Das Paket kann nicht gelesen werden: {reason}.",
        "Eine unverschlüsselte ZIP-Datei oder multipart/related mit einem XJDF-Dokument und der "
        "Zeichnung senden.",
    ),
    "xjdf.wrong-count": Text(
        "Das Paket muss genau eine Datei {names} enthalten, enthält aber {count}.",
        "Eine ZIP-Datei oder multipart/related mit einem XJDF- oder XJMF-Dokument und der "
        "Zeichnung senden.",
    ),
    "xjdf.no-parts": Text(
        "Die Multipart-Nachricht hat keine Teile.",
        "Die Teile mit der Grenze trennen, die der Header Content-Type nennt.",
    ),
    "xjdf.same-names": Text(
        "Zwei Dateien des Pakets haben denselben Namen.",
        "Jeder Datei einen eigenen Namen geben.",
    ),
    "xjdf.nested-parts": Text(
        "Ein Teil des Pakets enthält weitere Teile.",
        "Alle Dokumente und die Zeichnung als Teile eines einzigen multipart/related senden.",
    ),
    "xjdf.many-files": Text(
        "Das Paket hat mehr als {limit} Dateien.",
        "Nur die Dokumente einer Bestellung und ihre Zeichnung senden.",
    ),
    "xjdf.no-file": Text(
        "Die Datei „{url}“ ist nicht im Paket.",
        "Ein Paket senden, das sie unter diesem Namen enthält, oder die Zeichnung hochladen und "
        "als /api/v1/drawings/ID nennen. Dateien anderer Server werden nicht geholt.",
    ),
    "xjdf.too-large": Text(
        "{name} ist größer als {limit} MB.",
        "Eine kleinere Datei senden.",
    ),
    "xjmf.many-messages": Text(
        "Das Dokument hat mehr als {limit} Nachrichten.",
        "Mehrere Dokumente senden.",
    ),
}
