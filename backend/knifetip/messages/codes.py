"""codes: the codes of all messages that knifetip can report, with the types of their arguments.

The part of a code before the dot is the area of knifetip to which the message belongs.  The OpenAPI
description contains the codes and arguments as the schema ``Message``, so that a client can check
that its own catalogue is complete.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip.messages.catalogue import MESSAGES
from knifetip.messages.entry import Kind

#: Code of a text that was stored before messages had codes, or that another version sent.
STORED: Final = "stored.text"

#: Types of the arguments of each code.
CODES: Final[Mapping[str, Mapping[str, Kind]]] = {
    code: MESSAGES[code].arguments for code in sorted(MESSAGES)
}
