"""webhook: messages about endpoints of other systems, and deliveries to them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "webhook.bad-url": entry(
        "The URL of the webhook is not valid: {reason}.",
        "Use an http or https URL without a user name, such as https://erp.example/hooks.",
        reason="text",
    ),
    "webhook.forbidden-address": entry(
        "The address {address}, to which the URL of the webhook leads, is not permitted.",
        "Use the URL of another system. Link-local addresses and addresses of metadata services "
        "are never permitted. Private addresses are not permitted if the server runs with "
        "--no-webhook-private.",
        address="text",
    ),
    "webhook.inactive": entry(
        "The webhook {webhook} is switched off.",
        "Switch the webhook on, then try again.",
        webhook="text",
    ),
    "webhook.too-many": entry(
        "The server already has {count} webhooks, which is the largest number allowed.",
        "Delete a webhook that is no longer needed.",
        count="count",
    ),
    "webhook.unknown": entry(
        "The webhook {webhook} does not exist.",
        "Choose an id that GET /api/webhooks lists.",
        webhook="text",
    ),
    "webhook.unknown-delivery": entry(
        "The delivery {delivery} of this webhook does not exist.",
        "Choose one of the deliveries of the last 30 days, which GET /api/webhooks/ID/deliveries "
        "lists.",
        delivery="text",
    ),
}
