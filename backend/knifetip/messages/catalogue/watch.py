"""watch: messages about hot folders."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "watch.bad-sidecar": entry(
        "The file with the fields of the order cannot be read: {reason}.",
        "Write a JSON object with the fields of an order, such as board and copies.",
        reason="text",
    ),
    "watch.folder": entry(
        "The folder {folder} cannot be used: {reason}.",
        "Choose an existing folder with read and write permission.",
        folder="text",
        reason="text",
    ),
    "watch.large-sidecar": entry(
        "The file with the fields of the order is larger than {limit} MB.",
        "Write only the fields of the order into it.",
        limit="count",
    ),
    "watch.xjdf-fields": entry(
        "The JSON file of the XJDF order contains {names:, }. The XJDF document defines these "
        "fields.",
        "Remove these fields. Only {permitted:or} may be in the file.",
        names="texts",
        permitted="texts",
    ),
    "watch.no-drawing": entry(
        "The drawing {name} of the order did not arrive in the folder.",
        "Put the drawing into the folder, then the order again. Or put both into a package "
        "*.xjdf.zip.",
        name="text",
    ),
    "watch.no-object": entry(
        "The file with the fields of the order is not a JSON object.",
        "Write a JSON object with the fields of an order, such as board and copies.",
    ),
    "watch.other-drawing": entry(
        "The file with the fields of the order contains the field drawing, but the order is for "
        "the drawing beside it.",
        "Remove the field drawing.",
    ),
    "watch.taken": entry(
        "Another process already watches the folder {folder}.",
        "End the other process, or watch another folder.",
        folder="text",
    ),
}
