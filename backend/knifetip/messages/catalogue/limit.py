"""limit: messages about limits of clients, connections and storage."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "limit.too-many-connections": entry(
        "Too many connections to the server are open.",
        "Close connections, or try again in a moment.",
    ),
    "limit.too-many-listeners": entry(
        "Too many clients listen to the events of the server (limit: {limit}).",
        "Close pages of the server that are not needed, or start it with a greater "
        "--max-listeners.",
        limit="count",
    ),
    "limit.too-many-requests": entry(
        "This client sends too many requests: more than {rate} in a second on average.",
        "Send the request again in {seconds} s.",
        rate="count",
        seconds="count",
    ),
    "limit.too-slow": entry(
        "The request did not arrive in time.",
        "Send the whole request without a pause. Check the network connection.",
    ),
}
