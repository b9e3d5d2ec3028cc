"""server: requests, the server and the command line."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "server.address-in-use": entry(
        "Cannot listen on {host}:{port}: {reason}.",
        "Stop the program that uses the port, or choose another with --port.",
        host="text",
        port="count",
        reason="text",
    ),
    "server.answered": entry("{url} answered {status}.", url="text", status="count"),
    "server.busy": entry(
        "{waiting:# request waits|# requests wait} for a free process; this one was not started.",
        "Send it again in {seconds} s.",
        waiting="count",
        seconds="count",
    ),
    "server.database-silent": entry("The database does not answer.", "Try again in a moment."),
    "server.internal-error": entry(
        "Internal error. Nothing was cut.",
        "The server's log has the details.",
    ),
    "server.not-started": entry(
        "The server did not start with the database {database}.",
        "The log lines above show the cause.",
        database="text",
    ),
    "server.stopping": entry("The server is stopping.", "Try again in a moment."),
    "server.unreachable": entry(
        "Cannot reach {server}: {reason}.",
        "Check --server and the network.",
        server="text",
        reason="text",
    ),
    "request.body-too-large": entry(
        "A request may have at most {limit} MB here.",
        "Send it in several requests.",
        limit="count",
    ),
    "request.foreign-origin": entry(
        "Cross-site request refused: a page of another origin sent it.",
        "Send it from this server's page, or from a program that is not a browser.",
    ),
    "request.foreign-page": entry(
        "Cross-site request refused: a page of {origin} sent it.",
        "Send it from this server's page, or from a program that is not a browser.",
        origin="text",
    ),
    "request.html-form": entry(
        "The API does not accept {media}.",
        "Send it with Content-Type: application/json.",
        media="text",
    ),
    "request.invalid": entry(
        "The request cannot be read: {faults:; }.",
        "See /api/openapi.json for what is expected.",
        faults="texts",
    ),
    "request.key-needed": entry(
        "This request needs a key.",
        "Send Authorization: Bearer KEY, or sign in at the page.",
    ),
    "request.key-reused": entry(
        "The Idempotency-Key {key} was used for another request.",
        "Use a new key for a new request.",
        key="text",
    ),
    "request.local-only": entry(
        "Without a key this server answers only requests from its own machine.",
        "Start it with --key-file PATH or --key KEY, or open it at http://localhost.",
    ),
    "request.no-host": entry("A request needs exactly one Host header.", "Use HTTP/1.1."),
    "request.not-marked": entry(
        "The request does not show that it was not sent by a page of another site.",
        "Send an X-Knifetip header with it (any value).",
    ),
    "request.not-storable": entry("The request contains text or numbers that cannot be stored."),
    "request.nothing-there": entry(
        "There is nothing at {path}.",
        "See /api/openapi.json for the available paths.",
        path="text",
    ),
    "request.refused": entry("{detail}", detail="text"),
    "request.upload-too-large": entry(
        "A request may have at most {limit} MB here.",
        "Send a smaller drawing.",
        limit="count",
    ),
    "request.wrong-host": entry(
        "This server does not answer requests for the host {host!r}.",
        "Use its address, or start it with --allow-host and this name.",
        host="text",
    ),
    "request.wrong-key": entry("The key is wrong.", "Send Authorization: Bearer KEY."),
    "request.wrong-method": entry(
        "{method} is not supported at {path}.",
        "See /api/openapi.json for the supported methods.",
        method="text",
        path="text",
    ),
    "settings.bad-host": entry(
        "{host!r} is not a host name.",
        "Write NAME or NAME:PORT.",
        host="text",
    ),
    "settings.bad-key": entry(
        "{what} must have {shortest} to 200 ASCII characters without spaces; it has {length}.",
        "With --key-file PATH a random key is generated.",
        what="text",
        shortest="count",
        length="count",
    ),
    "settings.key-file": entry(
        "Cannot use the key file {file}: {reason}.",
        "Name a file that can be written.",
        file="text",
        reason="text",
    ),
    "settings.two-keys": entry("Both a key and a key file are given.", "Give one of them."),
    "command.bad-corner": entry(
        "--corner-at {text!r} is not X,Y=TYPE or X,Y=TYPE:K.",
        "Write for example --corner-at 300,100=C or 300,100=D:0.3.",
        text="text",
    ),
    "command.bad-layer": entry(
        "--layer {pair!r} is not NAME=TYPE.",
        "Write for example --layer FOLDS=crease.",
        pair="text",
    ),
    "command.bad-line-type": entry(
        "--layer {pair!r}: {reason}.",
        "Choose one of them.",
        pair="text",
        reason="text",
    ),
    "command.file-too-large": entry(
        "{path} is larger than {limit} MB.",
        "Export a single carton, without pictures.",
        path="text",
        limit="count",
    ),
    "command.no-such-layer": entry(
        "There is no layer {layer!r} in {file}.",
        "Its layers are {layers:, }.",
        layer="text",
        file="text",
        layers="texts",
    ),
    "command.unreadable-file": entry(
        "Cannot read {path}: {reason}.",
        "Check the file's name and permissions.",
        path="text",
        reason="text",
    ),
    "command.unwritable-file": entry(
        "Cannot write {path}: {reason}.",
        "Choose another path.",
        path="text",
        reason="text",
    ),
}
