"""Examples of requests and answers that are no JSON, in the REST description.

The tests send the examples of requests to a server.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from itertools import pairwise
from typing import Any, Final

from knifetip.library import load
from knifetip.service.description.examples import EXAMPLE_ID, EXAMPLE_TIME

_CORNERS = ((0, 0), (100, 0), (100, 80), (0, 80), (0, 0))
_LINES = "".join(
    f"0\nLINE\n8\nCUT\n10\n{a[0]}\n20\n{a[1]}\n11\n{b[0]}\n21\n{b[1]}\n"
    for a, b in pairwise(_CORNERS)
)
#: A rectangle of 100 mm by 80 mm on the layer CUT.
DXF: Final = (
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"
    f"0\nSECTION\n2\nENTITIES\n{_LINES}0\nENDSEC\n0\nEOF\n"
)
_XJDF_ORDER: Final = f"""\
<XJDF xmlns="http://www.CIP4.org/JDFSchema_2_0" JobID="PO-4711" Types="ShapeCutting Creasing"
  Version="2.2">
  <ResourceSet Name="NodeInfo" Usage="Input">
    <Resource><NodeInfo LastEnd="{EXAMPLE_TIME}"/></Resource>
  </ResourceSet>
  <ResourceSet Name="Device" Usage="Input">
    <Resource><Device DeviceID="demo-table"/></Resource>
  </ResourceSet>
  <ResourceSet Name="Media" Usage="Input">
    <Resource ExternalID="e-flute"><Media MediaType="CorrugatedBoard"/></Resource>
  </ResourceSet>
  <ResourceSet Name="DieLayout" Usage="Input">
    <Resource>
      <DieLayout><FileSpec URL="/api/v1/drawings/{EXAMPLE_ID}"/></DieLayout>
    </Resource>
  </ResourceSet>
  <ResourceSet Name="Component" Usage="Output">
    <Resource><AmountPool><PartAmount Amount="2"/></AmountPool><Component/></Resource>
  </ResourceSet>
</XJDF>
"""
_XJDF_STATUS: Final = f"""\
<XJDF xmlns="http://www.CIP4.org/JDFSchema_2_0" JobID="PO-4711" Types="ShapeCutting Creasing"
  Version="2.2">
  <ResourceSet Name="NodeInfo" Usage="Input">
    <Resource>
      <NodeInfo JobPriority="50" LastEnd="{EXAMPLE_TIME}" Status="InProgress"
        StatusDetails="running"/>
    </Resource>
  </ResourceSet>
  <ResourceSet Name="Device" Usage="Input">
    <Resource><Device DeviceID="demo-table"/></Resource>
  </ResourceSet>
  <ResourceSet Name="Media" Usage="Input"><Resource ExternalID="e-flute"/></ResourceSet>
  <ResourceSet Name="Component" Usage="Output">
    <Resource><AmountPool><PartAmount Amount="2"/></AmountPool><Component/></Resource>
  </ResourceSet>
</XJDF>
"""
_XJMF_QUERY: Final = f"""\
<XJMF xmlns="http://www.CIP4.org/JDFSchema_2_0" Version="2.2">
  <Header DeviceID="ERP" Time="{EXAMPLE_TIME}"/>
  <QueryQueueStatus>
    <Header DeviceID="ERP" ID="M1" Time="{EXAMPLE_TIME}"/>
    <QueueStatusParams><QueueFilter JobID="PO-4711"/></QueueStatusParams>
  </QueryQueueStatus>
</XJMF>
"""
_XJMF_STATUS: Final = f"""\
<XJMF xmlns="http://www.CIP4.org/JDFSchema_2_0" Version="2.2">
  <Header AgentName="knifetip" AgentVersion="1.2.0" DeviceID="demo-table" Time="{EXAMPLE_TIME}"/>
  <SignalStatus>
    <Header AgentName="knifetip" AgentVersion="1.2.0" DeviceID="demo-table" Time="{EXAMPLE_TIME}"/>
    <DeviceInfo Status="Production">
      <JobPhase Amount="1" JobID="PO-4711" QueueEntryID="{EXAMPLE_ID}" Status="InProgress"
        StatusDetails="running" TotalAmount="2"/>
    </DeviceInfo>
  </SignalStatus>
</XJMF>
"""
_XJMF_ANSWER: Final = f"""\
<XJMF xmlns="http://www.CIP4.org/JDFSchema_2_0" Version="2.2">
  <Header AgentName="knifetip" AgentVersion="1.2.0" DeviceID="knifetip" Time="{EXAMPLE_TIME}"/>
  <ResponseQueueStatus ReturnCode="0">
    <Header AgentName="knifetip" AgentVersion="1.2.0" DeviceID="knifetip" Time="{EXAMPLE_TIME}"
      refID="M1"/>
    <Queue QueueSize="1">
      <QueueEntry Activation="Active" JobID="PO-4711" QueueEntryID="{EXAMPLE_ID}" Status="Waiting"
        StatusDetails="queued" SubmissionTime="{EXAMPLE_TIME}"/>
    </Queue>
  </ResponseQueueStatus>
</XJMF>
"""
_SVG: Final = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 80">'
    '<path d="M0 0H100V80H0Z" fill="none" stroke="red"/></svg>'
)
_XJDF_MEDIA: Final = "application/vnd.cip4-xjdf+xml"
_XJMF_MEDIA: Final = "application/vnd.cip4-xjmf+xml"
_ORDER: Final = {"board": "e-flute", "external_id": "PO-4711", "copies": 2}
#: Examples of bodies by the id of the operation and the media type.
_REQUESTS: Final[Mapping[tuple[str, str], Any]] = {
    ("upload_drawing", "multipart/form-data"): {
        "file": DXF, "unit": "mm", "external_id": "PO-4711", "due": EXAMPLE_TIME,
    },
    ("place_order_with_file", "multipart/form-data"): {"file": DXF, "order": json.dumps(_ORDER)},
    ("order_by_xjdf", _XJDF_MEDIA): _XJDF_ORDER,
    ("answer_xjmf", _XJMF_MEDIA): _XJMF_QUERY,
}  # fmt: skip
_PROGRAM: Final = "(knifetip)\nG21 G90 G17\nG0 Z5.000\n"
#: Examples of answers by the id of the operation.
_ANSWERS: Final[Mapping[str, str]] = {
    "get_carton_picture": _SVG,
    "get_picture": _SVG,
    "get_test_piece_picture": _SVG,
    "get_program": _PROGRAM,
    "get_gateway_program": _PROGRAM,
    "export_machine": load.library_text("machines", "demo-table"),
    "export_board": load.library_text("boards", "e-flute"),
    "export_tool": load.library_text("tools", "static-knife"),
    "export_profile": load.library_text("profiles", "default"),
    "get_job_as_xjdf": _XJDF_STATUS,
    "get_job_status_as_xjmf": _XJMF_STATUS,
    "answer_xjmf": _XJMF_ANSWER,
}


def add_text_examples(operation: Mapping[str, Any]) -> None:
    """Add the examples of the bodies of an operation that are no JSON.

    Parameters
    ----------
    operation
        Description of the operation, which is changed.
    """
    name = operation["operationId"]
    for media, body in operation.get("requestBody", {}).get("content", {}).items():
        if (name, media) in _REQUESTS:
            body["example"] = _REQUESTS[name, media]
    if name in _ANSWERS:
        (answer,) = operation["responses"]["200"]["content"].values()
        answer["example"] = _ANSWERS[name]
