"""content: German texts of the messages of ``catalogue.content``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "content.altered": Text(
        "Der gespeicherte Inhalt {address} von {owner} ist beschädigt: Sein SHA-256 stimmt nicht.",
        "Den Inhalt aus einer Sicherung wiederherstellen oder den Auftrag neu berechnen. An keine "
        "Maschine wurde etwas gesendet.",
    ),
    "content.bad-url": Text(
        "„{url}“ ist nicht die URL eines Ordners oder eines Buckets.",
        "Die URL als file:///ORDNER oder s3://BUCKET/PREFIX schreiben, mit den Schlüsseln von S3 "
        "in AWS_ACCESS_KEY_ID und AWS_SECRET_ACCESS_KEY.",
    ),
    "content.missing": Text(
        "Der gespeicherte Inhalt {address} von {owner} fehlt.",
        "Prüfen, ob --store den Ordner oder das Bucket dieser Datenbank nennt. Wenn ja, den "
        "Inhalt aus einer Sicherung wiederherstellen oder den Auftrag neu berechnen. An keine "
        "Maschine wurde etwas gesendet.",
    ),
    "content.no-obstore": Text(
        "Das Paket obstore, das --store {url} braucht, ist nicht installiert.",
        "Installieren mit: pip install 'knifetip[s3]'.",
    ),
    "content.outside": Text(
        "Der gespeicherte Inhalt {address} von {owner} liegt in einem Ordner oder Bucket "
        "außerhalb der Datenbank.",
        "Server und Worker mit derselben Option --store starten wie beim Speichern des Inhalts.",
    ),
    "content.unavailable": Text(
        "Der Speicher {url} kann nicht benutzt werden: {reason}.",
        "Ordner oder Bucket, Schlüssel und Netzwerk prüfen. Nichts wurde gespeichert.",
    ),
}
