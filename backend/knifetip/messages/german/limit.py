"""limit: German texts of the messages of ``catalogue.limit``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "limit.disk-full": Text(
        "Die Festplatte des Servers ist voll, also wurde nichts gespeichert.",
        "Dateien auf dem Server löschen oder die Festplatte vergrößern, dann die Anfrage noch "
        "einmal senden. /readyz zeigt, wie viel frei ist.",
    ),
    "limit.disk-low": Text(
        "Auf der Festplatte des Servers sind nur {free} MB frei, und {least} MB sind für laufende "
        "Aufträge reserviert. Nichts wurde gespeichert.",
        "Dateien auf dem Server löschen oder die Festplatte vergrößern, dann die Anfrage noch "
        "einmal senden.",
    ),
    "limit.too-many-connections": Text(
        "Zu viele Verbindungen zum Server sind offen.",
        "Unbenutzte Verbindungen schließen oder gleich noch einmal versuchen.",
    ),
    "limit.too-many-listeners": Text(
        "Zu viele Ereignisströme des Servers sind offen (Grenze: {limit}).",
        "Nicht benötigte Seiten des Servers im Browser schließen oder den Server mit größerem "
        "--max-listeners starten.",
    ),
    "limit.too-many-requests": Text(
        "Dieser Client sendet zu viele Anfragen: im Mittel mehr als {rate} in der Sekunde.",
        "Die Anfrage in {seconds} s noch einmal senden.",
    ),
    "limit.too-slow": Text(
        "Die Anfrage kam nicht innerhalb der Zeitgrenze an.",
        "Die ganze Anfrage ohne Pause senden und die Netzwerkverbindung prüfen.",
    ),
}
