"""server: messages about requests, the server and the command line."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "process.name-taken": entry(
        "Another process with the name {name} already uses this database.",
        "Give each process a different name with --name, or stop the other process.",
        name="text",
    ),
    "server.bad-metrics-address": entry(
        "{address!r} is not a valid value of --metrics-address.",
        "Write it as HOST:PORT, such as 127.0.0.1:9464 or [::1]:9464.",
        address="text",
    ),
    "server.address-in-use": entry(
        "The server cannot use the address {host}:{port}: {reason}.",
        "Stop the program that uses the port, or choose another port with --port.",
        host="text",
        port="count",
        reason="text",
    ),
    "server.answered": entry(
        "The request to {url} failed with the HTTP status {status}.",
        "Check the address. The log of the server contains the cause.",
        url="text",
        status="count",
    ),
    "server.busy": entry(
        "The server is busy: {waiting:# request is|# requests are} already waiting, so this "
        "request was not started.",
        "Send the request again in {seconds} s.",
        waiting="count",
        seconds="count",
    ),
    "server.database-damaged": entry(
        "The database of the server is damaged.",
        "Stop the server and put a backup in its place: knifetip restore FILE --replace. Check the "
        "disk. Trying again does not help.",
    ),
    "server.database-silent": entry(
        "The database of the server does not respond.",
        "Try again in a moment. If this happens again, check the database.",
    ),
    "server.internal-error": entry(
        "Internal error of the server. Nothing was cut.",
        "Report the error with the log of the server.",
    ),
    "server.machine-taken": entry(
        "Another server ({holder}) already runs the simulated machine {machine} of this database.",
        "Stop that server, use another --database, or start this server with --no-simulator.",
        holder="text",
        machine="text",
    ),
    "server.not-started": entry(
        "The server could not start with the database {database}.",
        "Correct the cause, which the lines above this message state.",
        database="text",
    ),
    "server.stopping": entry(
        "The server is shutting down and accepts no new requests.",
        "Try again in a moment.",
    ),
    "server.unreachable": entry(
        "The server {server} cannot be reached: {reason}.",
        "Check the address in --server and the network connection.",
        server="text",
        reason="text",
    ),
    "request.body-too-large": entry(
        "The request is larger than {limit} MB, which is the limit for this URL.",
        "Divide the data into several requests.",
        limit="count",
    ),
    "request.body-unreadable": entry(
        "The body of the request cannot be read.",
        "Send JSON or multipart/form-data as /api/openapi.json describes, with the matching "
        "Content-Type.",
    ),
    "request.foreign-origin": entry(
        "The request was rejected, because a page of another website sent it.",
        "Send the request from the page of this server, or from a program that is not a browser.",
    ),
    "request.foreign-page": entry(
        "The request was rejected, because a page of another website ({origin}) sent it.",
        "Send the request from the page of this server, or from a program that is not a browser.",
        origin="text",
    ),
    "request.html-form": entry(
        "The API does not accept data of type {media}.",
        "Send JSON with Content-Type: application/json.",
        media="text",
    ),
    "request.invalid": entry(
        "The request is invalid: {faults:; }.",
        "{faults:hint} Correct these fields of the request. /api/openapi.json describes all "
        "fields.",
        faults="messages",
    ),
    "request.key-needed": entry(
        "This request needs the access key of the server.",
        "Send the access key in the header Authorization: Bearer KEY, or sign in on the page "
        "of the server.",
    ),
    "request.key-reused": entry(
        "The Idempotency-Key {key} was already used for a different request.",
        "Use a new key for each new request.",
        key="text",
    ),
    "request.local-only": entry(
        "This server has no access key, so it accepts only requests from its own computer.",
        "Start the server with --key-file PATH or --key KEY, or open the page of the server at "
        "http://localhost on the same computer.",
    ),
    "request.no-host": entry(
        "The request does not have exactly one Host header.",
        "Send one Host header, as HTTP/1.1 requires.",
    ),
    "request.not-base64": entry(
        "The content of the file {name} is not base64.",
        "Encode the bytes of the file in base64, without line breaks.",
        name="text",
    ),
    "request.one-drawing": entry(
        "An order needs exactly one of a file, the id of a stored drawing, a carton and a layout.",
        "Send the file (form part or JSON field file), or the field drawing, carton or layout.",
    ),
    "request.not-marked": entry(
        "The request lacks the header X-Knifetip, which protects the server against requests "
        "from other websites.",
        "Send the header X-Knifetip with any value.",
    ),
    "request.order-not-tried": entry(
        "This order was not processed, because an order before it failed. {reason}",
        "Send the request again with the same Idempotency-Key: orders that are already stored are "
        "not created twice.",
        reason="message",
    ),
    "request.not-storable": entry(
        "The request contains characters or numbers that the database cannot store.",
        "Remove control characters, and use finite numbers.",
    ),
    "request.outcome-unknown": entry(
        "An earlier request with this Idempotency-Key was begun, but it is not known whether it "
        "was executed.",
        "Check whether it was executed. If it was not, send the request again with a new key.",
    ),
    "request.secret-not-kept": entry(
        "A request with this Idempotency-Key was already executed. Its answer contained a secret, "
        "which the server does not store, so the answer cannot be repeated: see {path}.",
        "Get a new secret with POST {path}/rotate-secret.",
        path="text",
    ),
    "request.wrong-media": entry(
        "The content type {media} is not supported here.",
        "Send the body as {supported:or}, and name it in the header Content-Type.",
        media="text",
        supported="texts",
    ),
    "request.no-media": entry(
        "The request has a body but no Content-Type.",
        "Send the body as {supported:or}, and name it in the header Content-Type.",
        supported="texts",
    ),
    "request.nothing-there": entry(
        "The URL {path} does not exist on this server.",
        "Choose a URL that /api/openapi.json describes.",
        path="text",
    ),
    "request.refused": entry(
        "The request was rejected with the HTTP status {status}.",
        "Correct the request as /api/openapi.json describes.",
        status="count",
    ),
    "request.scope-missing": entry(
        "{principal} lacks the scope {scope}, which this request requires (present: {scopes:, }).",
        "Sign in as a user with the role {scope}, or use an API key with this scope.",
        principal="text",
        scope="text",
        scopes="texts",
    ),
    "request.unknown-zone": entry(
        "{zone!r} is not the name of a time zone.",
        "Use a name of the IANA time zone database, such as Europe/Berlin or UTC.",
        zone="text",
    ),
    "request.upload-too-large": entry(
        "The file is larger than {limit} MB, which is the limit of this server.",
        "Send a smaller file, for example without pictures.",
        limit="count",
    ),
    "request.wrong-host": entry(
        "This server does not accept requests for the host {host!r}.",
        "Use the IP address of the server, or start the server with --allow-host {host}.",
        host="text",
    ),
    "request.wrong-key": entry(
        "The access key of the request is wrong.",
        "Send the key of this server in the header Authorization: Bearer KEY.",
    ),
    "request.wrong-method": entry(
        "The method {method} is not supported at {path}.",
        "Choose a method that /api/openapi.json describes for this URL.",
        method="text",
        path="text",
    ),
    "settings.bad-file": entry(
        "The settings file {file} cannot be used: {reason}.",
        "Correct the file, or start the server without it.",
        file="text",
        reason="text",
    ),
    "settings.bad-host": entry(
        "{host!r} is not a host name.",
        "Write the host as NAME or NAME:PORT.",
        host="text",
    ),
    "settings.bad-key": entry(
        "{what} has {length} characters, but must have {shortest} to 200 ASCII characters without "
        "spaces.",
        "Choose another key, or let --key-file PATH generate one.",
        what="text",
        shortest="count",
        length="count",
    ),
    "settings.invalid": entry(
        "The settings cannot be used: {faults:; }.",
        "{faults:hint} The page Settings of the documentation lists all settings.",
        faults="messages",
    ),
    "settings.key-file": entry(
        "The key file {file} cannot be used: {reason}.",
        "Choose a file that the server can read and write.",
        file="text",
        reason="text",
    ),
    "settings.two-keys": entry(
        "The server was started with both --key and --key-file.",
        "Give only one of the two options.",
    ),
    "command.bad-corner": entry(
        "The option --corner-at {text!r} does not have the form X,Y=TYPE or X,Y=TYPE:K.",
        "Write for example --corner-at 300,100=C or --corner-at 300,100=D:0.3.",
        text="text",
    ),
    "command.bad-mark": entry(
        "The option --mark {text!r} does not have the form X,Y or X,Y=X,Y.",
        "Write for example --mark 5,5 or, for a measured mark, --mark 5,5=31.2,24.8.",
        text="text",
    ),
    "command.bad-option": entry(
        "The option {option} cannot be used: {faults:; }.",
        "{faults:hint} knifetip program --help describes all options.",
        option="text",
        faults="messages",
    ),
    "command.bad-edge": entry(
        "The option --edge {pair!r} does not have the form EDGE=TYPE or EDGE,EDGE=TYPE.",
        "Write for example --edge 12,13=ignored. The first edge has number 0.",
        pair="text",
    ),
    "command.bad-layer": entry(
        "The option --layer {pair!r} does not have the form NAME=TYPE.",
        "Write for example --layer FOLDS=crease.",
        pair="text",
    ),
    "command.bad-line-type": entry(
        "The line type in the option {pair!r} does not exist.",
        "Choose the line type {known:or}.",
        pair="text",
        known="texts",
    ),
    "command.file-too-large": entry(
        "The file {path} is larger than {limit} MB.",
        "Export a single carton, without pictures.",
        path="text",
        limit="count",
    ),
    "command.no-such-layer": entry(
        "The file {file} has no layer {layer!r}.",
        "Choose one of the layers of the file: {layers:, }.",
        layer="text",
        file="text",
        layers="texts",
    ),
    "command.unreadable-file": entry(
        "The file {path} cannot be read: {reason}.",
        "Check the name and the permissions of the file.",
        path="text",
        reason="text",
    ),
    "command.unwritable-file": entry(
        "The file {path} cannot be written: {reason}.",
        "Choose another path.",
        path="text",
        reason="text",
    ),
}
