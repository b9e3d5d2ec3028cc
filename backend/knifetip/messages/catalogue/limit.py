"""limit: messages about limits of clients, connections and storage."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "limit.disk-full": entry(
        "The disk of the server is full, so nothing was stored.",
        "Delete files on the server or enlarge its disk, then send the request again. /readyz "
        "shows how much is free.",
    ),
    "limit.disk-low": entry(
        "The disk of the server has only {free} MB free, and {least} MB are reserved for running "
        "jobs, so nothing was stored.",
        "Delete files on the server or enlarge its disk, then send the request again.",
        free="count",
        least="count",
    ),
    "limit.too-many-connections": entry(
        "Too many connections to the server are open.",
        "Close unused connections, or try again in a moment.",
    ),
    "limit.too-many-listeners": entry(
        "Too many event streams of the server are open (limit: {limit}).",
        "Close browser pages of the server that are not needed, or start the server with a "
        "greater --max-listeners.",
        limit="count",
    ),
    "limit.too-many-requests": entry(
        "This client sends too many requests: more than {rate} per second on average.",
        "Send the request again in {seconds} s.",
        rate="count",
        seconds="count",
    ),
    "limit.too-slow": entry(
        "The request did not arrive within the time limit.",
        "Send the whole request without a pause, and check the network connection.",
    ),
}
