"""xjdf: messages about orders in XJDF."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "xjdf.unreadable": entry(
        "The document is not readable as XML: {reason}.",
        "Send an XJDF or XJMF document without a document type declaration.",
        reason="text",
    ),
    "xjdf.not-xjdf": entry(
        "The root element of the document is {element}.",
        "Send an element {wanted} of the namespace {namespace}.",
        element="text",
        wanted="text",
        namespace="text",
    ),
    "xjdf.missing": entry(
        "The XJDF order lacks {place}.",
        "Add {place} to the document. Machine and board can also be query parameters of the "
        "request.",
        place="text",
    ),
    "xjdf.twice": entry(
        "The XJDF order contains several values of {place}.",
        "Send a separate order for each value.",
        place="text",
    ),
    "xjdf.bad-value": entry(
        "{place} has the value {value!r}, which is not supported.",
        "Use one of the values that the how-to page order-with-xjdf describes.",
        place="text",
        value="text",
    ),
    "xjdf.foreign-drawing": entry(
        "The drawing {url} is on another server than {host}, and is not fetched from there.",
        "Send the drawing in the package, or upload it to this server and name its path.",
        url="text",
        host="text",
    ),
    "xjdf.bad-name": entry(
        "The package contains a file with the unsafe name {name!r}.",
        "Use relative names without .., backslashes, colons and control characters.",
        name="text",
    ),
    "xjdf.bad-package": entry(
        "The package cannot be read: {reason}.",
        "Send an unencrypted ZIP file or multipart/related body with one XJDF document and the "
        "drawing.",
        reason="text",
    ),
    "xjdf.wrong-count": entry(
        "The package must contain exactly one file {names}, but contains {count}.",
        "Send a ZIP file or multipart/related body with one XJDF or XJMF document and the drawing.",
        names="text",
        count="count",
    ),
    "xjdf.no-parts": entry(
        "The multipart message has no parts.",
        "Separate the parts with the boundary that the header Content-Type states.",
    ),
    "xjdf.same-names": entry(
        "Two files of the package have the same name.",
        "Give each file a different name.",
    ),
    "xjdf.nested-parts": entry(
        "A part of the package contains further parts.",
        "Send all documents and the drawing as parts of one multipart/related.",
    ),
    "xjdf.many-files": entry(
        "The package has more than {limit} files.",
        "Send only the documents of one order and its drawing.",
        limit="count",
    ),
    "xjdf.no-file": entry(
        "The file {url!r} is not in the package.",
        "Send a package that contains it under this name, or upload the drawing and name it as "
        "/api/v1/drawings/ID. Files of other servers are not fetched.",
        url="text",
    ),
    "xjdf.too-large": entry(
        "{name} is larger than {limit} MB.",
        "Send a smaller file.",
        name="text",
        limit="count",
    ),
    "xjmf.many-messages": entry(
        "The document has more than {limit} messages.",
        "Send several documents.",
        limit="count",
    ),
}
