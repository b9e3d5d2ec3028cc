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
    "xjdf.bad-name": entry(
        "The package has a file with the name {name!r}, which leads out of the package.",
        "Use relative names without .., backslashes, colons and control characters.",
        name="text",
    ),
    "xjdf.bad-package": entry(
        "The package cannot be read: {reason}.",
        "Send a ZIP file or multipart/related, not encrypted, with one XJDF and the drawing.",
        reason="text",
    ),
    "xjdf.wrong-count": entry(
        "The package contains {names} {count} times instead of once.",
        "Send a ZIP file or multipart/related with one XJDF or XJMF and the drawing.",
        names="text",
        count="count",
    ),
    "xjdf.no-parts": entry(
        "The multipart message has no parts.",
        "Separate its parts by the boundary of the header Content-Type.",
    ),
    "xjdf.same-names": entry(
        "The package has two files with the same name.",
        "Give each file a name of its own.",
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
