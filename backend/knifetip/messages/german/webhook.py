"""webhook: German texts of the messages of ``catalogue.webhook``."""

from __future__ import annotations

from typing import Final

from knifetip.messages.language import Text, Texts

TEXTS: Final[Texts] = {
    "webhook.bad-url": Text(
        "Die URL des Webhooks ist ungültig: {reason}.",
        "Eine http- oder https-URL ohne Benutzernamen verwenden, etwa https://erp.example/hooks.",
    ),
    "webhook.forbidden-address": Text(
        "Die Adresse {address}, zu der die URL des Webhooks führt, ist nicht erlaubt.",
        "Die URL eines anderen Systems verwenden. Link-lokale Adressen und Adressen von "
        "Metadatendiensten sind nie erlaubt. Private Adressen sind nicht erlaubt, wenn der Server "
        "mit --no-webhook-private läuft.",
    ),
    "webhook.inactive": Text(
        "Der Webhook {webhook} ist ausgeschaltet.",
        "Den Webhook einschalten, dann noch einmal versuchen.",
    ),
    "webhook.too-many": Text(
        "Der Server hat schon {count} Webhooks, mehr sind nicht erlaubt.",
        "Einen nicht mehr benötigten Webhook löschen.",
    ),
    "webhook.unknown": Text(
        "Den Webhook {webhook} gibt es nicht.",
        "Eine Kennung wählen, die GET /api/webhooks nennt.",
    ),
    "webhook.unknown-delivery": Text(
        "Die Zustellung {delivery} dieses Webhooks gibt es nicht.",
        "Eine der Zustellungen der letzten 30 Tage wählen, die GET /api/webhooks/ID/deliveries "
        "nennt.",
    ),
}
