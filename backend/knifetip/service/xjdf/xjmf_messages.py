"""Messages of XJMF 2.x: read those of a document, and write the responses (ADR 96)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Final
from xml.etree.ElementTree import Element

from knifetip.errors import RequestError
from knifetip.service.xjdf.status import document_text, header, root_element, subelement
from knifetip.service.xjdf.xml import children, local_name, parse

_MOST_MESSAGES = 100  # of a document
_NAME: Final = re.compile(r"(Command|Query)([A-Za-z]{1,60})")
_NMTOKEN: Final = re.compile(r"[A-Za-z0-9._:-]{1,200}")


class ReturnCode(IntEnum):
    """Codes of responses that knifetip uses, as the specification lists them."""

    SUCCESS = 0
    GENERAL_ERROR = 1
    NOT_IMPLEMENTED = 5
    INVALID_PARAMETERS = 6
    INSUFFICIENT_PARAMETERS = 7
    BUSY = 10
    INCAPABLE = 101
    UNKNOWN_JOB = 103
    UNKNOWN_ENTRY = 105
    EXECUTING = 106
    SUBSCRIPTION_DENIED = 111
    ALREADY_SO = 113
    ENDED = 114
    NOT_RUNNING = 115
    NO_REFERENCED_FILE = 120
    UNKNOWN_DEVICE = 121
    DENIED = 300


@dataclass(frozen=True, slots=True)
class XjmfMessage:
    """A command or query of a document."""

    family: str  #: Command or Query
    name: str  #: such as SubmitQueueEntry
    id: str  #: Header/@ID; "" if it is missing
    element: Element
    index: int = 0  #: number of the message in its document, from 0

    def parameters(self, name: str) -> Element | None:
        """Return the child element with a name, None if there is none."""
        return next(iter(children(self.element, name)), None)


@dataclass(frozen=True, slots=True)
class XjmfAnswer:
    """The response to a message."""

    message: XjmfMessage
    code: ReturnCode = ReturnCode.SUCCESS
    comments: Sequence[str] = ()  #: reason of the failure, and a hint
    content: Sequence[Element] = field(default_factory=list)  #: elements after the notification


def read_messages(content: bytes) -> list[XjmfMessage]:
    """Return the commands and queries of an XJMF document.

    Raises
    ------
    RequestError
        The document is not readable, is no XJMF, or has no command or query, or too many.
    """
    root = parse(content, "XJMF")
    found: list[XjmfMessage] = []
    for element in root:
        if match := _NAME.fullmatch(local_name(element)):
            heads = children(element, "Header")
            id = heads[0].get("ID", "") if heads else ""
            found.append(XjmfMessage(match[1], match[2], id, element, len(found)))
    if not found:
        raise RequestError("xjdf.missing", place="XJMF/(Command…|Query…)")
    if len(found) > _MOST_MESSAGES:
        raise RequestError("xjmf.many-messages", limit=_MOST_MESSAGES)
    return found


def write_answers(answers: Sequence[XjmfAnswer], now: float) -> bytes:
    """Return the document with the responses.

    Parameters
    ----------
    answers
        The responses, in the order of the messages.
    now
        Present time (seconds since 1970).
    """
    root = root_element("XJMF")
    subelement(root, "Header", header(now))
    for answer in answers:
        attributes = {"ReturnCode": str(int(answer.code))}
        response = subelement(root, f"Response{answer.message.name}", attributes)
        head = header(now)
        if _NMTOKEN.fullmatch(answer.message.id):
            head["refID"] = answer.message.id
        subelement(response, "Header", head)
        if answer.comments:
            notification = subelement(response, "Notification", {"Class": "Error"})
            for text in answer.comments:
                subelement(notification, "Comment", {}).text = printable_xml(text)
        response.extend(answer.content)
    return document_text(root)


def printable_xml(text: str) -> str:
    """Return a text without the characters that XML cannot represent, and control characters."""
    return "".join(letter if letter.isprintable() else " " for letter in text)
