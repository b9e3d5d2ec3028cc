"""Write the state of a job as XJMF: a SignalStatus with one JobPhase (ADR 87)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from importlib.metadata import version
from typing import Final
from xml.etree import ElementTree

from knifetip.api.xjdf_order import NAMESPACE
from knifetip.jobs.job import State
from knifetip.jobs.tables import Job
from knifetip.jobs.time_text import rfc3339

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
    status = NODE_STATUS[State(row.state)]
    # A number of an order that is no NMTOKEN cannot have come by XJDF.
    number = row.external_id if _NMTOKEN.fullmatch(row.external_id) else row.id
    header = {"AgentName": "knifetip", "AgentVersion": version("knifetip")}
    header |= {"DeviceID": row.machine, "Time": rfc3339(now)}
    root = ElementTree.Element("XJMF", {"xmlns": NAMESPACE, "Version": "2.2"})
    ElementTree.SubElement(root, "Header", header)
    signal = ElementTree.SubElement(root, "SignalStatus")
    ElementTree.SubElement(signal, "Header", header)
    device = ElementTree.SubElement(
        signal, "DeviceInfo", {"Status": _DEVICE_STATUS.get(status, "Idle")}
    )
    ElementTree.SubElement(
        device,
        "JobPhase",
        {
            "Amount": str(row.copies_done),
            "JobID": number,
            "QueueEntryID": row.id,
            "Status": status,
            "StatusDetails": row.state,
            "TotalAmount": str(row.copies),
        },
    )
    text = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()
