"""Orders in XJDF and states in XJMF.

Expected names and values are those of the schema of CIP4 (xjdf.xsd, XJDF 2.x) and its samples.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from typing import Any

import httpx
import pytest

from knifetip.contract.job import State
from knifetip.errors import RequestError
from knifetip.service.xjdf.order import read_order
from knifetip.service.xjdf.status import NODE_STATUS
from tests.support.serving.server import square, upload_drawing

NAMESPACE = "http://www.CIP4.org/JDFSchema_2_0"
#: Type NodeStatus of the schema.
NODE_STATES = {
    *("Aborted", "Cleanup", "Completed", "InProgress", "Setup", "Stopped", "Suspended", "Waiting"),
}
ORDER = """<?xml version="1.0" encoding="UTF-8"?>
<XJDF xmlns="http://www.CIP4.org/JDFSchema_2_0" JobID="PO-4711" JobPartID="n_000002"
  Types="ShapeCutting Creasing" Version="2.2">
  <AuditPool><AuditCreated>
    <Header AgentName="ERP" DeviceID="dummy" Time="2024-03-26T14:14:46+00:00"/>
  </AuditCreated></AuditPool>
  <ResourceSet Name="CustomerInfo" Usage="Input"><Resource>
    <CustomerInfo CustomerID="K-12" CustomerJobName="Tray"/>
  </Resource></ResourceSet>
  <ResourceSet Name="NodeInfo" Usage="Input"><Resource>
    <NodeInfo FirstStart="2030-01-01T00:00:00+00:00" LastEnd="2030-01-02T04:04:05+01:00"/>
  </Resource></ResourceSet>
  <ResourceSet Name="Device" Usage="Input"><Resource>
    <Device DeviceID="demo-table"/>
  </Resource></ResourceSet>
  <ResourceSet Name="Media" Usage="Input"><Resource ExternalID="e-flute">
    <Media MediaType="CorrugatedBoard"/>
  </Resource></ResourceSet>
  <ResourceSet Name="DieLayout" Usage="Input"><Resource>
    <DieLayout><FileSpec URL="/api/v1/drawings/d7placeholder"/></DieLayout>
  </Resource></ResourceSet>
  <ResourceSet Name="Component" Usage="Output"><Resource>
    <AmountPool><PartAmount Amount="3"/></AmountPool><Component/>
  </Resource></ResourceSet>
</XJDF>
"""


def send(client: httpx.Client, text: str, **parameters: Any) -> httpx.Response:
    return client.post(
        "/api/v1/xjdf",
        content=text.encode(),
        params=parameters,
        headers={
            "Content-Type": "application/vnd.cip4-xjdf+xml",
            "Idempotency-Key": str(hash(text)),
        },
    )


def test_an_order_becomes_a_job_and_its_state_a_message(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    order = ORDER.replace("d7placeholder", drawing)
    answer = send(client, order)
    assert answer.status_code == 201, answer.text
    job = answer.json()
    assert send(client, order).json()["id"] == job["id"]
    found = client.get(f"/api/v1/jobs/{job['id']}").json()
    expected = {
        "drawing": drawing,
        "external_id": "PO-4711",
        "customer": "K-12",
        "due": "2030-01-02T03:04:05.000Z",
        "copies": 3,
        "machine": "demo-table",
        "board": "e-flute",
    }
    assert {name: found[name] for name in expected} == expected
    message = client.get(f"/api/v1/jobs/{job['id']}/xjmf")
    assert message.headers["content-type"] == "application/vnd.cip4-xjmf+xml"
    root = ElementTree.fromstring(message.content)
    assert root.tag == f"{{{NAMESPACE}}}XJMF"
    assert [child.tag.partition("}")[2] for child in root] == ["Header", "SignalStatus"]
    header = root.find(f"{{{NAMESPACE}}}Header")
    assert header is not None
    # Required by the schema.
    assert {"DeviceID", "Time"} <= set(header.keys())
    (phase,) = root.iter(f"{{{NAMESPACE}}}JobPhase")
    assert phase.get("JobID") == "PO-4711"
    assert phase.get("QueueEntryID") == job["id"]
    assert phase.get("Status") in NODE_STATES
    assert phase.get("TotalAmount") == "3"


def test_every_state_has_a_status_of_the_schema() -> None:
    assert NODE_STATUS.keys() == set(State)
    assert set(NODE_STATUS.values()) <= NODE_STATES


def test_machine_and_board_may_come_from_the_request(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    order = ORDER.replace("d7placeholder", drawing).replace(' ExternalID="e-flute"', "")
    answer = send(client, order)
    assert (answer.status_code, answer.json()["code"]) == (422, "xjdf.missing")
    assert send(client, order, board="e-flute").json()["board"] == "e-flute"


@pytest.mark.parametrize(
    ("old", "new", "code", "place"),
    [
        (' JobID="PO-4711"', "", "xjdf.missing", "XJDF/@JobID"),
        ('Types="ShapeCutting Creasing"', "", "xjdf.missing", "XJDF/@Types"),
        ("Creasing", "Folding", "xjdf.bad-value", "XJDF/@Types"),
        ("/api/v1/drawings/d7placeholder", "file:/host/a.cff2", "xjdf.bad-value", "FileSpec/@URL"),
        ("/api/v1/drawings/d7placeholder", "", "xjdf.missing", "FileSpec/@URL"),
        ('Amount="3"', 'Amount="0.5"', "xjdf.bad-value", "PartAmount/@Amount"),
        ('Amount="3"', 'Amount="INF"', "xjdf.bad-value", "PartAmount/@Amount"),
        ('Amount="3"', 'Amount="many"', "xjdf.bad-value", "PartAmount/@Amount"),
        (
            "</AmountPool>",
            '<PartAmount Amount="4"/></AmountPool>',
            "xjdf.twice",
            "PartAmount/@Amount",
        ),
        ("JDFSchema_2_0", "JDFSchema_1_1", "xjdf.not-xjdf", "JDFSchema_1_1"),
        ("</XJDF>", "", "xjdf.unreadable", ""),
        (
            "<XJDF xmlns",
            '<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]><XJDF xmlns',
            "xjdf.unreadable",
            "",
        ),
        (
            "<XJDF xmlns",
            '<!DOCTYPE x SYSTEM "file:///etc/passwd"><XJDF xmlns',
            "xjdf.unreadable",
            "",
        ),
        ('encoding="UTF-8"', 'encoding="no-such"', "xjdf.unreadable", ""),
    ],
)
def test_errors_name_the_element(old: str, new: str, code: str, place: str) -> None:
    text = ORDER.replace(old, new)
    assert text != ORDER
    with pytest.raises(RequestError) as refused:
        read_order(text.encode())
    assert refused.value.message.code == code
    assert place in refused.value.text


@pytest.mark.parametrize(
    ("old", "new", "status"),
    [
        ('Amount="3"', 'Amount="1000000"', 422),
        ("2030-01-02T04:04:05+01:00", "soon", 422),
        ("e-flute", "no-such", 404),
        ("d7placeholder", "nosuch", 404),
    ],
)
def test_the_order_is_checked_like_any_other(
    client: httpx.Client, old: str, new: str, status: int
) -> None:
    drawing = upload_drawing(client, square())["id"]
    answer = send(client, ORDER.replace(old, new).replace("d7placeholder", drawing))
    assert answer.status_code == status, answer.text
    assert answer.json()["hint"]


@pytest.mark.parametrize(("stated", "priority"), [("", 0), ("50", 0), ("100", 50), ("0", -50)])
def test_the_priority_of_an_order_is_that_in_the_queue(
    client: httpx.Client, stated: str, priority: int
) -> None:
    drawing = upload_drawing(client, square())["id"]
    attribute = f'JobPriority="{stated}" ' if stated else ""
    order = ORDER.replace("d7placeholder", drawing).replace("<NodeInfo ", f"<NodeInfo {attribute}")
    job = send(client, order)
    assert job.status_code == 201, job.text
    assert job.json()["priority"] == priority
    text = client.get(f"/api/v1/jobs/{job.json()['id']}/xjdf").text
    (info,) = ElementTree.fromstring(text).iter(f"{{{NAMESPACE}}}NodeInfo")
    assert info.get("JobPriority") == (stated or "50")


@pytest.mark.parametrize(
    "stated", ["101", "-1", "1.5", "high", "\u0665", "9" * 5000, "0" * 12 + "99"]
)
def test_another_priority_is_refused_with_its_place(client: httpx.Client, stated: str) -> None:
    answer = send(client, ORDER.replace("<NodeInfo ", f'<NodeInfo JobPriority="{stated}" '))
    assert answer.status_code == 422, answer.text
    assert answer.json()["arguments"]["place"] == "NodeInfo/@JobPriority"
