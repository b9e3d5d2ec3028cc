"""Read an order from an XJDF document: the subset for cutting and creasing of ADR 87."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Final
from urllib.parse import urlsplit
from xml.etree.ElementTree import Element

from knifetip.errors import RequestError
from knifetip.messages.characters import TextKind, control_character, printable
from knifetip.service.xjdf.xml import children, parse

#: Processes that a machine can execute; an order with others is refused.
PROCESSES: Final = ("Cutting", "ShapeCutting", "Creasing")

#: Default and greatest value of NodeInfo/@JobPriority; greater ones come first, as here.
DEFAULT_JOB_PRIORITY: Final = 50
MAX_JOB_PRIORITY: Final = 100

_DRAWING: Final = re.compile(r"(?:https?://([^/?#]+)/|/)?api/(?:v\d+/)?drawings/([a-z0-9]{1,32})")
#: Resources that name the file of a die layout.
_WITH_FILE: Final = ("DieLayout", "ShapeDef", "CuttingParams")


@dataclass(frozen=True, slots=True)
class XjdfOrder:
    """The order in an XJDF document; fields that it does not contain are empty."""

    drawing: str  #: id of an uploaded drawing; "" if the order names a file of its package
    file: str  #: URL of the drawing in the package: relative, or cid:; "" for an uploaded one
    external_id: str  #: XJDF/@JobID
    customer: str  #: CustomerInfo/@CustomerID
    due: str  #: NodeInfo/@LastEnd, otherwise NodeInfo/@End
    priority: int  #: NodeInfo/@JobPriority above its default
    copies: int  #: AmountPool/PartAmount/@Amount of the output component; 1 if it is missing
    machine: str  #: Device/@DeviceID
    board: str  #: Resource/@ExternalID of the input medium


def read_order(content: bytes, host: str = "") -> XjdfOrder:
    """Return the order in an XJDF document.

    Elements and attributes outside the subset are disregarded, except processes: an order for
    folding, for example, is refused.

    Parameters
    ----------
    content
        The document.
    host
        Name and port of this server, as the request names it; "" for a document without drawings on
        a server.

    Raises
    ------
    RequestError
        The document is not well-formed, declares a document type, is no XJDF, or lacks an element;
        the message names the element.
    """
    root = parse(content, "XJDF")
    _check_processes(root)
    nodes = _resources(root, "NodeInfo", "Input")
    drawing, file = _drawing(root, host)
    return XjdfOrder(
        drawing=drawing,
        file=file,
        external_id=_require_value(root.get("JobID", ""), "XJDF/@JobID"),
        customer=_only_value(
            _attributes(root, "CustomerInfo", "CustomerID"), "CustomerInfo/@CustomerID"
        ),
        due=_only_value(
            [
                node.get("LastEnd", node.get("End", ""))
                for resource in nodes
                for node in children(resource, "NodeInfo")
            ],
            "NodeInfo/@LastEnd",
        ),
        priority=_priority(nodes),
        copies=_copies(root),
        machine=_only_value(_attributes(root, "Device", "DeviceID"), "Device/@DeviceID"),
        board=_only_value(
            [resource.get("ExternalID", "") for resource in _resources(root, "Media", "Input")],
            "ResourceSet[@Name='Media']/Resource/@ExternalID",
        ),
    )


def _check_processes(root: Element) -> None:
    processes = root.get("Types", "").split()
    if not processes:
        raise RequestError("xjdf.missing", place="XJDF/@Types")
    for process in processes:
        if process not in PROCESSES:
            raise RequestError("xjdf.bad-value", place="XJDF/@Types", value=process[:100])


def _drawing(root: Element, host: str) -> tuple[str, str]:
    """Return the id of the ordered drawing, or the URL of its file in the package."""
    urls = [
        file.get("URL", "")
        for name in _WITH_FILE
        for resource in _resources(root, name, "Input")
        for holder in children(resource, name)
        for file in children(holder, "FileSpec")
    ]
    url = _require_value(_only_value(urls, "FileSpec/@URL"), "FileSpec/@URL of an input DieLayout")
    if match := _DRAWING.fullmatch(url):
        if match[1] is not None and match[1].lower() != host.lower():
            raise RequestError("xjdf.foreign-drawing", url=url[:200], host=host)
        return match[2], ""
    parts = urlsplit(url)
    relative = not parts.scheme and not parts.netloc and not parts.path.startswith("/")
    if not (relative or parts.scheme == "cid"):
        raise RequestError("xjdf.bad-value", place="FileSpec/@URL", value=url[:200])
    return "", url


def _priority(nodes: list[Element]) -> int:
    """Return the priority of a job in the queue of its machine; 0 if the order has none."""
    place = "NodeInfo/@JobPriority"
    text = _only_value(
        [
            node.get("JobPriority", "")
            for resource in nodes
            for node in children(resource, "NodeInfo")
        ],
        place,
    )
    if not text:
        return 0
    is_number = text.isascii() and text.isdecimal() and len(text) <= len(str(MAX_JOB_PRIORITY))
    if not is_number or int(text) > MAX_JOB_PRIORITY:
        raise RequestError("xjdf.bad-value", place=place, value=text[:100])
    return int(text) - DEFAULT_JOB_PRIORITY


def _copies(root: Element) -> int:
    place = "PartAmount/@Amount"
    text = _only_value(
        [
            part.get("Amount", "")
            for resource in _resources(root, "Component", "Output")
            for pool in children(resource, "AmountPool")
            for part in children(pool, "PartAmount")
        ],
        place,
    )
    if not text:
        return 1
    try:
        amount = float(text)
    except ValueError:
        amount = math.nan
    # JobIn has the upper limit.
    if not (math.isfinite(amount) and amount >= 1.0 and amount == int(amount)):
        raise RequestError("xjdf.bad-value", place=place, value=text[:100])
    return int(amount)


def _resources(root: Element, name: str, usage: str) -> list[Element]:
    """Return the resources in all sets with a name; a set without usage counts."""
    return [
        resource
        for found in children(root, "ResourceSet")
        if found.get("Name") == name and found.get("Usage", usage) == usage
        for resource in children(found, "Resource")
    ]


def _attributes(root: Element, name: str, attribute: str) -> list[str]:
    return [
        element.get(attribute, "")
        for resource in _resources(root, name, "Input")
        for element in children(resource, name)
    ]


def _only_value(values: list[str], place: str) -> str:
    """Return the only value that is not empty, "" if there is none."""
    found = {_check_readable(value, place) for value in values} - {""}
    if len(found) > 1:
        raise RequestError("xjdf.twice", place=place)
    return found.pop() if found else ""


def _require_value(value: str, place: str) -> str:
    if not (readable := _check_readable(value, place)):
        raise RequestError("xjdf.missing", place=place)
    return readable


def _check_readable(value: str, place: str) -> str:
    """Return a value without blanks around it; refuse one with control characters."""
    if control_character(value, TextKind.LINE):
        raise RequestError("xjdf.bad-value", place=place, value=printable(value)[:100])
    return value.strip()
