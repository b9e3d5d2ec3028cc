"""Details of orders: stored with drawings and jobs, returned, changed and found."""

from __future__ import annotations

import json
from datetime import UTC, datetime, timedelta
from typing import Any

import httpx
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from knifetip.service.http.times import rfc3339, seconds_of
from tests.support.serving.server import square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

DETAILS: dict[str, Any] = {
    "external_id": "PO-4711",
    "customer": "Höfler & Söhne",
    "due": "2030-01-02T05:04:05+02:00",
    "notes": "Bring to gate 7",
    "metadata": {"line": 3, "weight": 1.5, "urgent": True, "site": "Graz"},
}
RETURNED = {**DETAILS, "due": "2030-01-02T03:04:05.000Z"}


def order(client: httpx.Client, drawing: str, **fields: Any) -> httpx.Response:
    body = {"drawing": drawing, "machine": "demo-table", "board": "e-flute", **fields}
    return client.post("/api/v1/jobs", json=body)


def details(row: dict[str, Any]) -> dict[str, Any]:
    return {name: row[name] for name in DETAILS}


@pytest.fixture(scope="module")
def drawing(client: httpx.Client) -> str:
    return str(upload_drawing(client, square(side=77.0))["id"])


def test_a_job_returns_its_details_everywhere(client: httpx.Client, drawing: str) -> None:
    job = order(client, drawing, **DETAILS).json()
    assert details(job) == RETURNED
    assert details(client.get(f"/api/v1/jobs/{job['id']}").json()) == RETURNED
    listed = client.get("/api/v1/jobs", params={"drawing": drawing}).json()
    assert details(listed[0]) == RETURNED
    plain = order(client, drawing).json()
    empty: dict[str, Any] = {
        "external_id": "",
        "customer": "",
        "due": None,
        "notes": "",
        "metadata": {},
    }
    assert details(plain) == empty


def test_details_of_a_job_change_in_every_state(client: httpx.Client, drawing: str) -> None:
    job = order(client, drawing, **DETAILS).json()["id"]
    url = f"/api/v1/jobs/{job}"
    assert client.post(f"{url}/cancel").status_code == 200
    changed = client.patch(url, json={"notes": "late", "due": None}).json()
    assert details(changed) == {**RETURNED, "notes": "late", "due": None}
    assert client.patch(url, json={"metadata": {"line": 4}}).json()["metadata"] == {"line": 4}
    found = client.get("/api/v1/jobs", params={"metadata.line": "4", "drawing": drawing}).json()
    assert [row["id"] for row in found] == [job]
    # A change that is refused changes nothing.
    refused = client.patch(url, json={"notes": "lost", "priority": 5})
    assert refused.status_code == 409
    assert client.get(url).json()["notes"] == "late"
    events = client.get(f"{url}/events").json()
    assert [event["message"]["code"] for event in events].count("job.details-changed") == 2


FILTERS: list[tuple[dict[str, str], set[int]]] = [
    ({"external_id": "F-1"}, {0}),
    ({"external_id": "f-1"}, set()),
    ({"customer": "Müller"}, {0, 1}),
    ({"due_before": "2031-01-01T00:00:00Z"}, {0}),
    ({"due_before": "2030-06-01T00:00:00Z"}, set()),
    ({"due_after": "2030-06-01T02:00:00+02:00"}, {0, 1}),
    ({"due_after": "2030-06-01T00:00:00.001Z"}, {1}),
    ({"notes": "GATE"}, {1}),
    ({"notes": "100%"}, {2}),
    ({"notes": "_"}, set()),
    ({"metadata.site": "Graz"}, {0, 2}),
    ({"metadata.line": "3"}, {0}),
    ({"metadata.line": "3", "metadata.site": "Graz"}, {0}),
    ({"metadata.urgent": "true"}, {1}),
    ({"metadata.weight": "2"}, {2}),
    ({"metadata.weight": "2.0"}, set()),
    ({"customer": "Müller", "metadata.site": "Wien"}, {1}),
]
ROWS: list[dict[str, Any]] = [
    {
        "external_id": "F-1",
        "customer": "Müller",
        "due": "2030-06-01T00:00:00Z",
        "metadata": {"site": "Graz", "line": 3},
    },
    {
        "customer": "Müller",
        "due": "2031-06-01T00:00:00Z",
        "notes": "at gate 7",
        "metadata": {"site": "Wien", "urgent": True},
    },
    {"notes": "100% recycled", "metadata": {"site": "Graz", "weight": 2.0}},
    {},
]


@pytest.fixture(scope="module")
def rows(client: httpx.Client) -> tuple[str, list[str], list[str]]:
    """The drawing of the jobs; the ids of jobs and of drawings with the details of ``ROWS``."""
    drawings = []
    for index, row in enumerate(ROWS):
        data = {**row, "metadata": json.dumps(row.get("metadata", {}))}
        files = {"file": (f"f{index}.dxf", square(side=60.0 + index))}
        answer = client.post("/api/v1/drawings", files=files, data=data)
        assert answer.status_code == 201, answer.text
        drawings.append(answer.json()["id"])
    jobs = [order(client, drawings[3], **row).json()["id"] for row in ROWS]
    return drawings[3], jobs, drawings


@pytest.mark.parametrize(("query", "expected"), FILTERS)
def test_lists_are_filtered(
    client: httpx.Client,
    rows: tuple[str, list[str], list[str]],
    query: dict[str, str],
    expected: set[int],
) -> None:
    drawing, jobs, drawings = rows
    found = client.get("/api/v1/jobs", params={**query, "drawing": drawing}).json()
    assert {jobs.index(row["id"]) for row in found} == expected
    own = client.get("/api/v1/drawings", params=query).json()
    found_drawings = {row["id"] for row in own} & set(drawings)
    assert {drawings.index(id) for id in found_drawings} == expected


def test_a_page_of_a_filtered_list_leads_to_the_next(
    client: httpx.Client, rows: tuple[str, list[str], list[str]]
) -> None:
    query = {"metadata.site": "Graz", "drawing": rows[0], "limit": 1}
    url = str(httpx.URL("/api/v1/jobs", params=query))
    visited = []
    for _ in range(2):
        answer = client.get(url)
        visited += [rows[1].index(row["id"]) for row in answer.json()]
        link = answer.headers["link"]
        url = link[1 : link.index(">")]
    assert visited == [2, 0]
    assert client.get(url).json() == []


def test_history_is_filtered(client: httpx.Client, rows: tuple[str, list[str], list[str]]) -> None:
    job = rows[1][1]
    client.post(f"/api/v1/jobs/{job}/cancel")
    found = client.get("/api/v1/history", params={"customer": "Müller", "limit": 500}).json()
    assert job in {row["id"] for row in found}
    found = client.get("/api/v1/history", params={"customer": "Meier"}).json()
    assert found == []


def test_details_of_a_drawing_change_without_reading_it_again(client: httpx.Client) -> None:
    before = upload_drawing(client, square(side=83.0))
    url = f"/api/v1/drawings/{before['id']}"
    stale = client.patch(url, json={"notes": "x"}, headers={"If-Match": '"7"'})
    assert stale.status_code == 412
    changed = client.patch(url, json=DETAILS, headers={"If-Match": '"1"'})
    assert details(changed.json()) == RETURNED
    assert changed.json()["revision"] == 2
    assert changed.headers["etag"] == '"2"'
    both = client.patch(url, json={"unit": "cm", "customer": "B"}).json()
    assert (both["unit"], both["customer"], both["notes"]) == ("cm", "B", DETAILS["notes"])
    found = client.get("/api/v1/drawings", params={"metadata.site": "Graz", "customer": "B"})
    assert [row["id"] for row in found.json()] == [before["id"]]
    assert details(found.json()[0]) == {**RETURNED, "customer": "B"}
    assert client.delete(url).status_code == 204


def test_the_rest_of_a_sheet_has_the_details_of_its_job(client: httpx.Client, drawing: str) -> None:
    job = order(client, drawing, **DETAILS).json()["id"]
    wait_for_state(client, job, "ready")
    client.post(f"/api/v1/jobs/{job}/cancel")
    again = client.post(f"/api/v1/jobs/{job}/rest", json={"whole": True})
    assert again.status_code == 201, again.text
    assert details(again.json()) == RETURNED
    found = client.get("/api/v1/jobs", params={"metadata.line": "3", "drawing": drawing}).json()
    assert again.json()["id"] in {row["id"] for row in found}


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"external_id": "x" * 201}, "field.too-long"),
        ({"notes": "x" * 2001}, "field.too-long"),
        ({"due": "tomorrow"}, "field.not-a-time"),
        ({"due": "2030-01-02T03:04:05"}, "field.not-a-time"),
        ({"due": "2030-02-30T03:04:05Z"}, "field.not-a-time"),
        ({"due": 1893456000}, "field.not-a-time"),
        ({"metadata": {"a": None}}, None),
        ({"metadata": {"a": [1]}}, None),
        ({"metadata": {str(n): n for n in range(33)}}, "field.too-many"),
        ({"metadata": {str(n): "x" * 300 for n in range(30)}}, "field.metadata-too-large"),
        ({"metadata": {"": 1}}, "field.too-short"),
    ],
)
def test_details_that_are_not_permitted_are_refused(
    client: httpx.Client, drawing: str, fields: dict[str, Any], code: str | None
) -> None:
    answer = order(client, drawing, **fields)
    assert answer.status_code == 422
    codes = [fault["code"] for fault in answer.json()["arguments"]["faults"]]
    assert code is None or codes == [code]


@pytest.mark.parametrize("text", ["{", "[]", '{"a": {}}', "nonsense"])
def test_metadata_of_a_form_must_be_an_object(client: httpx.Client, text: str) -> None:
    files = {"file": ("a.dxf", square())}
    answer = client.post("/api/v1/drawings", files=files, data={"metadata": text})
    assert answer.status_code == 422
    assert answer.json()["source"][0].startswith("body.metadata")


@given(st.datetimes(min_value=datetime(1, 1, 2), max_value=datetime(9999, 12, 30)))
@settings(deadline=None)
def test_a_time_is_read_as_it_was_written(moment: datetime) -> None:
    exact = moment.replace(tzinfo=UTC, microsecond=moment.microsecond // 1000 * 1000)
    seconds = (exact - datetime(1970, 1, 1, tzinfo=UTC)) / timedelta(seconds=1)
    # A double has no exact milliseconds far from 1970.
    assert seconds_of(exact.isoformat()) == pytest.approx(seconds, abs=1e-4)
    shown = datetime.fromisoformat(rfc3339(seconds))
    assert timedelta(milliseconds=-1) <= shown - exact <= timedelta(0)


def test_times_are_written_in_utc_with_milliseconds() -> None:
    assert rfc3339(0.0) == "1970-01-01T00:00:00.000Z"
    assert rfc3339(1893553445.1239) == "2030-01-02T03:04:05.123Z"
    assert rfc3339(-0.5) == "1969-12-31T23:59:59.500Z"
    assert rfc3339(1e300) == "9999-12-31T23:59:59.999Z"
    assert rfc3339(-1e300) == "0001-01-01T00:00:00.000Z"
    assert seconds_of("2030-01-02t03:04:60z") == seconds_of("2030-01-02T03:05:00+00:00")
    assert seconds_of("2030-01-02T03:04:05.5-01:30") == 1893553445.5 + 5400.0
    assert seconds_of("2030-01-02 03:04:05Z") == 1893553445.0
    for text in (
        "2030-01-02",
        "2030-13-02T03:04:05Z",
        "2030-01-02T24:00:00Z",
        "٢٠٣٠-01-02T03:04:05Z",
    ):
        assert seconds_of(text) is None
