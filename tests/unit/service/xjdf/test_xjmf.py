"""Messages in XJMF: the queue of a printing workflow, mapped to the commands to jobs."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from xml.etree.ElementTree import Element

import httpx
import pytest

from knifetip.service.settings import Settings
from tests.support.serving.server import (
    LocalClient,
    confirm_job,
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)
from tests.unit.service.xjdf.test_packages import order_for, related, zipped

pytestmark = pytest.mark.xdist_group("xjmf")

NS = "{http://www.CIP4.org/JDFSchema_2_0}"
HEADER = 'DeviceID="ERP" Time="2026-01-02T03:04:05+01:00"'
MEDIA = "application/vnd.cip4-xjmf+xml"


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("xjmf")
    settings = Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test")
    with run_server(settings) as client:
        yield client


def xjmf(*messages: str) -> bytes:
    parts = [
        message.replace("<HEAD/>", f'<Header ID="M{index}" {HEADER}/>')
        for index, message in enumerate(messages)
    ]
    return f'<XJMF xmlns="{NS[1:-1]}"><Header {HEADER}/>{"".join(parts)}</XJMF>'.encode()


def ask(client: httpx.Client, content: bytes, media: str = MEDIA) -> list[Element]:
    """Send messages; return the responses."""
    answer = client.post("/api/v1/xjmf", content=content, headers={"Content-Type": media})
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == MEDIA
    root = ElementTree.fromstring(answer.content)
    assert root.tag == f"{NS}XJMF"
    assert root[0].tag == f"{NS}Header"
    return list(root)[1:]


def code(response: Element) -> int:
    return int(response.get("ReturnCode", "-1"))


def modify(operation: str, job: str) -> str:
    return (
        f'<CommandModifyQueueEntry><HEAD/><ModifyQueueEntryParams Operation="{operation}">'
        f'<QueueFilter QueueEntryIDs="{job}"/></ModifyQueueEntryParams></CommandModifyQueueEntry>'
    )


def status(job: str) -> str:
    return (
        "<QueryQueueStatus><HEAD/><QueueStatusParams>"
        f'<QueueFilter QueueEntryIDs="{job}"/></QueueStatusParams></QueryQueueStatus>'
    )


def entry(response: Element) -> dict[str, str]:
    (found,) = response.iter(f"{NS}QueueEntry")
    return found.attrib


def ready_job(shop: LocalClient, **fields: object) -> str:
    job = str(order_job(shop, upload_drawing(shop, square())["id"], **fields)["id"])
    wait_for_state(shop, job, "ready")
    return job


def submit(url: str, activation: str = "") -> str:
    attribute = f' Activation="{activation}"' if activation else ""
    return (
        f'<CommandSubmitQueueEntry><HEAD/><QueueSubmissionParams URL="{url}"{attribute}/>'
        "</CommandSubmitQueueEntry>"
    )


def test_a_package_with_message_order_and_drawing_is_submitted(shop: LocalClient) -> None:
    files = {
        "root.xjmf": xjmf(submit("jobs/one.xjdf", "Held"), submit("jobs/none.xjdf")),
        "jobs/one.xjdf": order_for("art/tray.dxf", "PO-held"),
        "art/tray.dxf": square(side=81.0),
    }
    held, missing = ask(shop, zipped(files), "application/vnd.cip4-xjmf+zip")
    assert held.tag == f"{NS}ResponseSubmitQueueEntry"
    assert (code(held), code(missing)) == (0, 120)
    headers = [header for one in (held, missing) for header in one.findall(f"{NS}Header")]
    assert [header.get("refID") for header in headers] == ["M0", "M1"]
    found = entry(held)
    assert (found["JobID"], found["Status"]) == ("PO-held", "Waiting")
    wait_for_state(shop, found["QueueEntryID"], "ready")
    (answer,) = ask(shop, xjmf(status(found["QueueEntryID"])))
    assert (entry(answer)["StatusDetails"], entry(answer)["Activation"]) == ("ready", "Held")
    media, body = related(xjmf(submit("cid:tray@erp.example")), b"<XJDF/>", "vnd.cip4-xjmf+xml")
    (wrong,) = ask(shop, body, media)
    assert code(wrong) == 6


def test_a_job_is_released_held_and_removed(shop: LocalClient) -> None:
    job = ready_job(shop)
    steps = [
        ("Resume", 0, "queued", "Active"),
        ("Resume", 113, "", ""),
        ("Suspend", 115, "", ""),
        ("Hold", 0, "queued", "Held"),
        ("Hold", 113, "", ""),
        ("Resume", 0, "queued", "Active"),
        ("Remove", 0, "cancelled", "Active"),
        ("Remove", 113, "", ""),
        ("Hold", 114, "", ""),
        ("Resume", 114, "", ""),
    ]
    for operation, expected, state, activation in steps:
        (response,) = ask(shop, xjmf(modify(operation, job)))
        assert response.tag == f"{NS}ResponseModifyQueueEntry"
        assert code(response) == expected, (operation, ElementTree.tostring(response))
        if expected == 0:
            assert response.find(f"{NS}Notification") is None
            assert (entry(response)["StatusDetails"], entry(response)["Activation"]) == (
                state,
                activation,
            )
        else:
            assert response.findtext(f"{NS}Notification/{NS}Comment")
    assert shop.get(f"/api/jobs/{job}").json()["state"] == "cancelled"


def test_a_running_job_is_suspended_and_aborted(shop: LocalClient) -> None:
    job = ready_job(shop)
    shop.post(f"/api/jobs/{job}/release")
    claim = {"machine": "demo-table", "gateway": "g", "wait": 0.0}
    claimed = shop.post("/api/gateway/claim", json=claim).json()
    assert claimed["job"] == job
    assert confirm_job(shop, job).status_code == 200
    lease = {"job": job, "epoch": claimed["epoch"], "line": 0, "waiting": True}
    assert shop.post("/api/gateway/heartbeat", json=lease).json()["command"] == "start"
    (answer,) = ask(shop, xjmf(status(job)))
    assert entry(answer)["Status"] == "InProgress"
    for operation, expected, action in (
        ("Remove", 106, ""),
        ("Hold", 106, ""),
        ("Resume", 113, ""),
        ("Suspend", 0, "hold"),
        ("Abort", 0, "cancel"),
    ):
        (response,) = ask(shop, xjmf(modify(operation, job)))
        assert code(response) == expected, (operation, ElementTree.tostring(response))
        if action:
            assert shop.get(f"/api/jobs/{job}").json()["requested_action"] == action
    end = {"job": job, "epoch": claimed["epoch"], "outcome": "cancelled"}
    assert shop.post("/api/gateway/finish", json=end).status_code == 200


def test_a_job_that_waits_for_a_new_sheet_is_not_resumed_by_any_way(shop: LocalClient) -> None:
    job = ready_job(shop, copies=2)
    shop.post(f"/api/jobs/{job}/release")
    claim = {"machine": "demo-table", "gateway": "g", "wait": 0.0}
    claimed = shop.post("/api/gateway/claim", json=claim).json()
    assert claimed["job"] == job
    assert confirm_job(shop, job).status_code == 200
    lease = {"job": job, "epoch": claimed["epoch"], "line": 0, "waiting": True}
    assert shop.post("/api/gateway/heartbeat", json=lease).json()["command"] == "start"
    lines = shop.get(f"/api/jobs/{job}").json()["lines"]
    between = {**lease, "line": lines, "waiting": False, "copies_done": 1, "held": True}
    assert shop.post("/api/gateway/heartbeat", json=between).json()["command"] == "continue"
    (answer,) = ask(shop, xjmf(modify("Resume", job)))
    assert code(answer) != 0
    assert "waits for a new sheet" in str(answer.findtext(f"{NS}Notification/{NS}Comment"))
    phase = shop.get(f"/api/jobs/{job}").json()["phase"]
    for body in (None, {}, {"phase": None}, {"phase": phase}):
        refused = shop.post(f"/api/jobs/{job}/resume", json=body)
        assert (refused.status_code, refused.json()["code"]) == (409, "job.needs-sheet")
        assert "confirm the job" in refused.json()["hint"]
    assert shop.post("/api/gateway/heartbeat", json=between).json()["command"] == "continue"
    assert confirm_job(shop, job).status_code == 200
    assert shop.post("/api/gateway/heartbeat", json=between).json()["command"] == "resume"
    shop.post(f"/api/jobs/{job}/cancel")
    assert shop.post("/api/gateway/heartbeat", json=between).json()["command"] == "cancel"
    end = {"job": job, "epoch": claimed["epoch"], "outcome": "cancelled"}
    assert shop.post("/api/gateway/finish", json=end).status_code == 200


def test_the_queue_is_queried(shop: LocalClient) -> None:
    job = ready_job(shop, external_id="PO-query")
    by_number = (
        '<QueryQueueStatus><HEAD/><QueueStatusParams><QueueFilter JobID="PO-query"/>'
        "</QueueStatusParams></QueryQueueStatus>"
    )
    by_status = by_number.replace('PO-query"', 'PO-query" StatusList="Completed Aborted"')
    one = f'<QueryStatus><HEAD/><StatusQuParams QueueEntryID="{job}"/></QueryStatus>'
    everything, found, none, phase, unknown, ended = ask(
        shop,
        xjmf(
            "<QueryQueueStatus><HEAD/></QueryQueueStatus>",
            by_number,
            status("no-such"),
            one,
            "<QueryStatus><HEAD/></QueryStatus>",
            by_status,
        ),
    )
    assert job in {one.get("QueueEntryID") for one in everything.iter(f"{NS}QueueEntry")}
    assert entry(found)["QueueEntryID"] == job
    assert code(none) == 105
    (job_phase,) = phase.iter(f"{NS}JobPhase")
    assert (job_phase.get("JobID"), job_phase.get("Status")) == ("PO-query", "Waiting")
    assert code(unknown) == 7
    assert code(ended) == 0


@pytest.mark.parametrize(
    ("message", "expected"),
    [
        ("<CommandShutDown><HEAD/></CommandShutDown>", 5),
        ("<QueryFortune><HEAD/></QueryFortune>", 5),
        ("<CommandHoldQueueEntry><HEAD/></CommandHoldQueueEntry>", 5),
        (modify("SetGang", "x"), 5),
        (modify("Abort", "no-such"), 105),
        ("<CommandModifyQueueEntry><HEAD/></CommandModifyQueueEntry>", 7),
        (modify("Abort", "x").replace(' QueueEntryIDs="x"', ""), 7),
        ("<CommandSubmitQueueEntry><HEAD/></CommandSubmitQueueEntry>", 7),
        (submit("http://erp.example/order.xjdf"), 120),
        (submit("order.xjdf", "Informative"), 6),
        (
            '<QueryQueueStatus><HEAD/><Subscription URL="http://erp/"/></QueryQueueStatus>',
            111,
        ),
    ],
)
def test_what_cannot_be_done_has_its_return_code(
    shop: LocalClient, message: str, expected: int
) -> None:
    (response,) = ask(shop, xjmf(message))
    assert code(response) == expected
    assert response.findtext(f"{NS}Notification/{NS}Comment")
    header = response.find(f"{NS}Header")
    assert header is not None
    assert header.get("refID") == "M0"


def test_known_messages_are_listed(shop: LocalClient) -> None:
    (response,) = ask(shop, xjmf("<QueryKnownMessages><HEAD/></QueryKnownMessages>"))
    types = {one.get("Type") for one in response.iter(f"{NS}MessageService")}
    assert {"CommandSubmitQueueEntry", "CommandModifyQueueEntry", "QueryQueueStatus"} <= types


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"", "xjdf.unreadable"),
        (b"<!DOCTYPE x [<!ENTITY a 'b'>]>" + xjmf(modify("Abort", "x")), "xjdf.unreadable"),
        (b'<!DOCTYPE x SYSTEM "http://erp/x.dtd">' + xjmf(modify("Hold", "x")), "xjdf.unreadable"),
        (order_for("a.dxf"), "xjdf.not-xjdf"),
        (xjmf(), "xjdf.missing"),
        (xjmf(*["<QueryStatus><HEAD/></QueryStatus>"] * 101), "xjmf.many-messages"),
        (xjmf("<!--" + "x" * (5 << 20) + "-->"), "xjdf.too-large"),
    ],
)
def test_documents_that_are_no_messages(shop: LocalClient, content: bytes, expected: str) -> None:
    answer = shop.post("/api/v1/xjmf", content=content, headers={"Content-Type": MEDIA})
    assert (answer.status_code, answer.json()["code"]) == (422, expected)


def test_a_job_is_written_as_xjdf(shop: LocalClient) -> None:
    job = ready_job(shop, external_id="PO-back", customer="K-12", copies=4)
    answer = shop.get(f"/api/v1/jobs/{job}/xjdf")
    assert answer.headers["content-type"] == "application/vnd.cip4-xjdf+xml"
    root = ElementTree.fromstring(answer.content)
    assert (root.tag, root.get("JobID")) == (f"{NS}XJDF", "PO-back")
    (info,) = root.iter(f"{NS}NodeInfo")
    assert (info.get("Status"), info.get("StatusDetails")) == ("Waiting", "ready")
    (amount,) = root.iter(f"{NS}PartAmount")
    assert amount.get("Amount") == "4"
    (phase,) = root.iter(f"{NS}JobPhase")
    assert phase.get("QueueEntryID") == job


@pytest.mark.parametrize(
    "condition", ['DeviceIDs="v-groove-table"', 'NewerThan="2030-01-01T00:00:00Z"', 'Jobid="x"']
)
def test_a_command_with_a_condition_that_is_not_supported_changes_nothing(
    shop: LocalClient, condition: str
) -> None:
    """It would end jobs that the condition excludes."""
    job = ready_job(shop, external_id="PO-condition")
    command = modify("Abort", job).replace("<QueueFilter", f"<QueueFilter {condition}")
    (response,) = ask(shop, xjmf(command))
    assert code(response) == 6
    assert condition.partition("=")[0] in response.findtext(f"{NS}Notification/{NS}Comment", "")
    assert shop.get(f"/api/jobs/{job}").json()["state"] == "ready"
    (response,) = ask(shop, xjmf(modify("Abort", " ".join([job] * 201))))
    assert code(response) == 6
    details = 'QueueEntryDetails="Brief" StatusList="Waiting"'
    command = modify("Abort", job).replace("<QueueFilter", f"<QueueFilter {details}")
    (response,) = ask(shop, xjmf(command))
    assert code(response) == 0


def test_two_orders_without_ids_are_two_jobs_under_one_key(shop: LocalClient) -> None:
    one = submit("one.xjdf", "Held").replace("<HEAD/>", f"<Header {HEADER}/>")
    files = {
        "root.xjmf": xjmf(one, one),
        "one.xjdf": order_for("tray.dxf", "PO-twice"),
        "tray.dxf": square(side=84.0),
    }
    headers = {"Content-Type": "application/vnd.cip4-xjmf+zip", "Idempotency-Key": "two-orders"}
    for _ in range(2):
        answer = shop.post("/api/v1/xjmf", content=zipped(files), headers=headers)
        responses = list(ElementTree.fromstring(answer.content))[1:]
        assert [code(response) for response in responses] == [0, 0]
        assert len({entry(response)["QueueEntryID"] for response in responses}) == 2
    assert len(shop.get("/api/jobs", params={"external_id": "PO-twice"}).json()) == 2
