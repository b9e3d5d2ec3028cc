"""Write the state of a job as XJDF and as XJMF (ADR 87, 96)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from importlib.metadata import version
from typing import Final
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from knifetip.contract.job import State
from knifetip.service.database.tables import Job
from knifetip.service.http.time_text import rfc3339
from knifetip.service.xjdf.order import DEFAULT_JOB_PRIORITY, MAX_JOB_PRIORITY
from knifetip.service.xjdf.xml import NAMESPACE

#: NodeStatus of each state of a job.
NODE_STATUS: Final[Mapping[State, str]] = {
    State.RECEIVED: "Waiting",
    State.COMPILING: "Waiting",
    State.READY: "Waiting",
    State.QUEUED: "Waiting",
    State.RUNNING: "InProgress",
    State.HELD: "Stopped",
    State.INTERRUPTED: "Stopped",
    State.DONE: "Completed",
    State.REFUSED: "Aborted",
    State.SCRAPPED: "Aborted",
    State.CONTINUED: "Aborted",
    State.CANCELLED: "Aborted",
}
_DEVICE_STATUS: Final = {"InProgress": "Production", "Stopped": "Stopped"}
#: A text that XML Schema accepts as NMTOKEN, in ASCII.
_NMTOKEN: Final = re.compile(r"[A-Za-z0-9._:-]+")


def status_message(row: Job, now: float) -> bytes:
    """Return the state of a job as an XJMF document.

    Parameters
    ----------
    row
        The job.
    now
        Present time (seconds since 1970).
    """
    root = root_element("XJMF")
    subelement(root, "Header", header(now, row.machine))
    signal = subelement(root, "SignalStatus", {})
    subelement(signal, "Header", header(now, row.machine))
    signal.append(device_info(row))
    return document_text(root)


def status_document(row: Job, now: float) -> bytes:
    """Return a job as an XJDF document, with its state.

    Parameters
    ----------
    row
        The job.
    now
        Present time (seconds since 1970).
    """
    root = root_element("XJDF")
    # The processes of the order are not stored: a die line is cut to its shape, and creased.
    root.attrib |= {"JobID": _job_id(row), "Types": "ShapeCutting Creasing"}
    audits = subelement(root, "AuditPool", {})
    audit = subelement(audits, "AuditStatus", {})
    subelement(audit, "Header", header(now, row.machine))
    audit.append(device_info(row))
    if _NMTOKEN.fullmatch(row.customer):
        _resource(root, "CustomerInfo", "Input", {"CustomerID": row.customer})
    info = {"Status": NODE_STATUS[State(row.state)], "StatusDetails": row.state}
    priority = min(max(row.priority + DEFAULT_JOB_PRIORITY, 0), MAX_JOB_PRIORITY)
    info["JobPriority"] = str(priority)
    if row.due is not None:
        info["LastEnd"] = rfc3339(row.due)
    _resource(root, "NodeInfo", "Input", info)
    _resource(root, "Device", "Input", {"DeviceID": _token(row.machine)})
    # Media/@MediaType is required, and not known: the resource only names the board.
    board = subelement(root, "ResourceSet", {"Name": "Media", "Usage": "Input"})
    subelement(board, "Resource", {"ExternalID": _token(row.board)})
    component = _resource(root, "Component", "Output", {})
    pool = Element("AmountPool")
    subelement(pool, "PartAmount", {"Amount": str(row.copies)})
    component.insert(0, pool)
    return document_text(root)


def device_info(row: Job) -> Element:
    """Return the ``DeviceInfo`` with the ``JobPhase`` of a job."""
    status = NODE_STATUS[State(row.state)]
    device = Element("DeviceInfo", {"Status": _DEVICE_STATUS.get(status, "Idle")})
    phase = {
        "Amount": str(row.copies_done),
        "JobID": _job_id(row),
        "QueueEntryID": row.id,
        "Status": status,
        "StatusDetails": row.state,
        "TotalAmount": str(row.copies),
    }
    subelement(device, "JobPhase", phase)
    return device


def queue_entry(row: Job) -> Element:
    """Return the ``QueueEntry`` of a job; one that is not released is ``Held``."""
    held = row.on_hold or row.state == State.READY
    attributes = {
        "Activation": "Held" if held else "Active",
        "JobID": _job_id(row),
        "QueueEntryID": row.id,
        "Status": NODE_STATUS[State(row.state)],
        "StatusDetails": row.state,
        "SubmissionTime": rfc3339(row.created),
    }
    return Element("QueueEntry", attributes)


def root_element(name: str) -> Element:
    """Return a root element of the namespace."""
    return Element(name, {"xmlns": NAMESPACE, "Version": "2.2"})


def subelement(parent: Element, name: str, attributes: Mapping[str, str]) -> Element:
    """Append an element to another one, and return it."""
    return ElementTree.SubElement(parent, name, dict(attributes))


def header(now: float, device: str = "knifetip") -> dict[str, str]:
    """Return the attributes of a ``Header``.

    Parameters
    ----------
    now
        Present time (seconds since 1970).
    device
        Name of the machine, or of the server.
    """
    head = {"AgentName": "knifetip", "AgentVersion": version("knifetip")}
    return head | {"DeviceID": _token(device), "Time": rfc3339(now)}


def document_text(root: Element) -> bytes:
    """Return a document as UTF-8."""
    text = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def _resource(root: Element, name: str, usage: str, attributes: Mapping[str, str]) -> Element:
    """Append a set with one resource; return the resource."""
    found = subelement(root, "ResourceSet", {"Name": name, "Usage": usage})
    resource = subelement(found, "Resource", {})
    subelement(resource, name, attributes)
    return resource


def _job_id(row: Job) -> str:
    # A number of an order that is no NMTOKEN cannot have come by XJDF.
    return row.external_id if _NMTOKEN.fullmatch(row.external_id) else row.id


def _token(name: str) -> str:
    """Return a name as NMTOKEN."""
    return re.sub(r"[^A-Za-z0-9._:-]", "_", name) or "_"
