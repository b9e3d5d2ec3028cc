"""xjdf: messages about orders in XJDF."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "xjdf.unreadable": entry(
        "The order is not readable as XML: {reason}.",
        "Send an XJDF document without a document type declaration.",
        reason="text",
    ),
    "xjdf.not-xjdf": entry(
        "The root element of the order is {element}.",
        "Send an element XJDF of the namespace {namespace}.",
        element="text",
        namespace="text",
    ),
    "xjdf.missing": entry(
        "The order has no {place}.",
        "Add it, or give the value as a parameter of the request if there is one.",
        place="text",
    ),
    "xjdf.twice": entry(
        "The order has several values of {place}.",
        "Send one order for each of them.",
        place="text",
    ),
    "xjdf.bad-value": entry(
        "{place} is {value!r}, which cannot be used.",
        "Correct the value as the how-to about XJDF describes.",
        place="text",
        value="text",
    ),
}
