"""webhook: messages about endpoints of other systems, and deliveries to them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "webhook.bad-url": entry(
        "The URL of the webhook is not usable: {reason}.",
        "Give an http or https URL without user name, such as https://erp.example/hooks.",
        reason="text",
    ),
    "webhook.forbidden-address": entry(
        "The webhook would be sent to the address {address}, which is not permitted.",
        "Give the URL of another system. Addresses of link-local networks and of metadata services "
        "are never permitted; private addresses only without --no-webhook-private.",
        address="text",
    ),
    "webhook.inactive": entry(
        "The webhook {webhook} is switched off.",
        "Switch it on first.",
        webhook="text",
    ),
    "webhook.too-many": entry(
        "There are already {count} webhooks, which is the limit.",
        "Delete a webhook that is no longer needed.",
        count="count",
    ),
    "webhook.unknown": entry(
        "There is no webhook {webhook}.",
        "GET /api/webhooks lists the webhooks.",
        webhook="text",
    ),
    "webhook.unknown-delivery": entry(
        "There is no delivery {delivery} of this webhook.",
        "GET /api/webhooks/ID/deliveries lists the deliveries of the last 30 days.",
        delivery="text",
    ),
}
