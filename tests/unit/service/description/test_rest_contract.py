"""The contract of REST: what the description states about errors, keys, versions and lists."""

from __future__ import annotations

import json
import re
from typing import Any
from urllib.parse import urlsplit

import httpx
import pytest

from knifetip.service.accounts.access_rules import AccessRules, Refusal, RequestFacts, find_access
from knifetip.service.database.tables import Operation
from tests.support.examples import is_quick
from tests.support.serving.server import order_job, square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")

#: Words that only Python, its libraries and its databases use.
PYTHON = re.compile(
    r"b'|b\"|\bNone\b|\bTrue\b|\bFalse\b|Traceback|Errno|codec|Error\(|Exception|<class|at 0x"
    r"|\bdict\b|\btuple\b|\bstr\b|\(char \d+\)|DTDForbidden|pydantic|sqlalchemy|int_max"
)
HOOK = {"url": "http://127.0.0.1:9/hook"}


@pytest.fixture(scope="module")
def described(client: httpx.Client) -> dict[str, Any]:
    answer: dict[str, Any] = client.get("/api/openapi.json").json()
    return answer


def keyed(key: str) -> dict[str, str]:
    return {"Idempotency-Key": key}


def test_the_type_of_each_error_has_the_documented_form(
    client: httpx.Client, described: dict[str, Any]
) -> None:
    schema = described["components"]["schemas"]["Problem"]["properties"]["type"]
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing)["id"]
    answers = [
        client.get("/api/jobs/none"),
        client.get("/api/nothing"),
        client.post(f"/api/jobs/{job}/finish"),
        client.post("/api/jobs", json={}),
        client.post("/api/jobs", content=b"x", headers={"Content-Type": "text/csv"}),
        client.put("/api/jobs"),
    ]
    types = [answer.json()["type"] for answer in answers]
    assert all(re.fullmatch(schema["pattern"], one) for one in types)
    assert types == [
        "urn:knifetip:problem:not-found",
        "about:blank",
        "urn:knifetip:problem:wrong-state",
        "urn:knifetip:problem:request",
        "urn:knifetip:problem:unsupported-media",
        "about:blank",
    ]
    assert "about:blank" in schema["description"]
    assert "urn:knifetip:problem:" in schema["description"]


def test_bodies_of_definitions_and_answers_of_schemas_and_events_are_described(
    client: httpx.Client, described: dict[str, Any]
) -> None:
    schemas = described["components"]["schemas"]
    for shelf, word in (("machines", "Machine"), ("boards", "Board"), ("tools", "Tool")):
        body = described["paths"][f"/api/{shelf}/{{name}}"]["put"]["requestBody"]["content"]
        assert body["application/json"]["schema"] == {
            "$ref": f"#/components/schemas/{word}Definition"
        }
        own = client.get(f"/api/schemas/{shelf}").json()
        assert schemas[f"{word}Definition"]["properties"].keys() == own["properties"].keys()
    text = json.dumps(described)
    assert "#/$defs/" not in text
    for name in re.findall(r'"#/components/schemas/([^"]+)"', text):
        assert name in schemas
    events = described["paths"]["/api/events"]["get"]["responses"]["200"]
    assert "`JobOut`" in events["description"]
    answer = described["paths"]["/api/schemas/{kind}"]["get"]["responses"]["200"]["content"]
    assert "$schema" in answer["application/json"]["schema"]["properties"]


def test_every_post_that_is_not_of_a_gateway_has_an_idempotency_key(
    described: dict[str, Any],
) -> None:
    without = {
        operation["operationId"]
        for item in described["paths"].values()
        for method, operation in item.items()
        if method == "post"
        and not any(one["name"] == "Idempotency-Key" for one in operation.get("parameters", ()))
    }
    assert without == {"sign_in", "claim", "heartbeat", "finish", "report_station"}


def connect(client: httpx.Client) -> None:
    """Report that the machine waits for operations, as its gateway does."""
    report = {
        **{"machine": "demo-table", "gateway": "g", "connected": True, "state": "idle"},
        **{"position": [0.0, 0.0, 20.0, 0.0], "operations": ["unlock", "home"], "wait": 0.0},
    }
    assert client.post("/api/gateway/station", json=report).status_code == 200


def test_a_repeated_jog_moves_once(client: httpx.Client) -> None:
    connect(client)
    before = operations(client)
    path, body = "/api/machines/demo-table/operations", {"operation": "unlock"}
    first = client.post(path, json=body, headers=keyed("jog-1"))
    again = client.post(path, json=body, headers=keyed("jog-1"))
    assert (first.status_code, again.status_code) == (202, 202)
    assert again.json() == first.json()
    assert "Idempotency-Replayed" not in first.headers
    assert again.headers["Idempotency-Replayed"] == "true"
    assert operations(client) == before + 1
    other = client.post(path, json={"operation": "home"}, headers=keyed("jog-1"))
    assert (other.status_code, other.json()["code"]) == (422, "request.key-reused")
    assert client.post(path, json=body, headers=keyed("x" * 201)).status_code == 422
    assert operations(client) == before + 1


def operations(client: httpx.Client) -> int:
    from sqlalchemy import func, select

    from tests.support.serving.server import LocalClient

    assert isinstance(client, LocalClient)
    with client.service.store.database.reading() as session:
        return session.scalar(select(func.max(Operation.serial))) or 0


def test_a_refused_request_is_executed_when_it_is_repeated(client: httpx.Client) -> None:
    wrong = client.post("/api/webhooks", json={"url": "ftp://x"}, headers=keyed("hook-0"))
    again = client.post("/api/webhooks", json={"url": "ftp://x"}, headers=keyed("hook-0"))
    assert (wrong.status_code, again.status_code) == (422, 422)
    assert "Idempotency-Replayed" not in again.headers
    right = client.post("/api/webhooks", json=HOOK, headers=keyed("hook-0"))
    assert right.status_code == 201
    client.delete(f"/api/webhooks/{right.json()['id']}")


@pytest.mark.parametrize(
    ("path", "body"),
    [("/api/webhooks", HOOK), ("/api/keys", {"title": "ERP", "scopes": ["read"]})],
)
def test_a_repeated_request_for_a_secret_makes_nothing_and_names_how_to_get_one(
    client: httpx.Client, path: str, body: dict[str, object]
) -> None:
    made = client.post(path, json=body, headers=keyed(f"secret {path}"))
    count = len(client.get(path).json())
    again = client.post(path, json=body, headers=keyed(f"secret {path}"))
    assert (made.status_code, again.status_code) == (201, 409)
    problem = again.json()
    place = f"{path}/{made.json()['id']}"
    assert (problem["code"], problem["arguments"]["path"]) == ("request.secret-not-kept", place)
    assert made.json()["secret"] not in again.text
    assert len(client.get(path).json()) == count
    rotated = client.post(f"{place}/rotate-secret")
    assert rotated.status_code == 200
    assert rotated.json()["secret"] != made.json()["secret"]
    client.delete(place)


def test_a_request_whose_outcome_is_not_known_is_not_executed_again(client: httpx.Client) -> None:
    from sqlalchemy import update

    from knifetip.service.database.tables import AnsweredRequest
    from tests.support.serving.server import LocalClient

    assert isinstance(client, LocalClient)
    path, body = "/api/machines/demo-table/operations", {"operation": "unlock"}
    connect(client)
    client.post(path, json=body, headers=keyed("lost"))
    # The server died between the operation and its answer.
    with client.service.store.database.writing() as session:
        session.execute(update(AnsweredRequest).values(status=0))
    before = operations(client)
    again = client.post(path, json=body, headers=keyed("lost"))
    assert (again.status_code, again.json()["code"]) == (409, "request.outcome-unknown")
    assert operations(client) == before


def test_a_change_of_a_job_is_refused_if_it_was_changed_meanwhile(client: httpx.Client) -> None:
    job = order_job(client, upload_drawing(client, square())["id"])["id"]
    path = f"/api/jobs/{job}"
    tag = client.get(path).headers["ETag"]
    assert "X-Tag-Prefix" not in client.get(path).headers
    assert client.get(path, headers={"If-None-Match": tag}).status_code in (200, 304)
    first = client.patch(path, json={"notes": "a"}, headers={"If-Match": tag})
    second = client.patch(path, json={"notes": "b"}, headers={"If-Match": tag})
    assert (first.status_code, second.status_code) == (200, 412)
    assert second.json()["code"] == "job.changed"
    assert client.get(path).json()["notes"] == "a"
    newest = client.get(path).headers["ETag"]
    for match in (newest, "*", f'W/{newest}, "x"'):
        assert client.patch(path, json={"notes": "a"}, headers={"If-Match": match}).is_success


def test_a_drawing_that_was_changed_meanwhile_is_not_deleted(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())
    path = f"/api/drawings/{drawing['id']}"
    client.patch(path, json={"notes": "new"})
    assert client.delete(path, headers={"If-Match": '"1"'}).status_code == 412
    assert client.delete(path, headers={"If-Match": '"2"'}).status_code == 204


def test_head_has_the_headers_of_get_and_no_body(
    client: httpx.Client, described: dict[str, Any]
) -> None:
    assert "HEAD" in described["info"]["description"]
    drawing = upload_drawing(client, square())["id"]
    names = {"kind": "machines"}
    for path, item in described["paths"].items():
        known = path.replace("/machines/{name}", "/machines/demo-table")
        if "get" not in item or "{" in known.replace("{kind}", ""):
            continue
        url = known.format(**names)
        if path == "/api/events":
            assert client.head(url).status_code == 200
            continue
        got, head = client.get(url), client.head(url)
        assert (head.status_code, head.content) == (got.status_code, b""), url
        assert head.headers["content-type"] == got.headers["content-type"], url
    for path in (f"/api/drawings/{drawing}", "/api/jobs/none", "/"):
        got, head = client.get(path), client.head(path)
        assert (head.status_code, head.content) == (got.status_code, b"")
        assert head.headers.get("etag") == got.headers.get("etag")


def test_every_list_has_pages(client: httpx.Client, described: dict[str, Any]) -> None:
    lists = {
        path: {one["name"] for one in item["get"].get("parameters", ())}
        for path, item in described["paths"].items()
        if "get" in item
        and item["get"]["responses"]["200"].get("content", {}).get("application/json", {})
        and item["get"]["responses"]["200"]["content"]["application/json"]["schema"].get("type")
        == "array"
    }
    without = {path for path, names in lists.items() if not {"cursor", "limit"} <= names}
    # Each of these is one document: sums of periods, the tracks of a program, the pages of a file,
    # and what the last drawings of a customer teach.
    whole_documents = {"jobs/{id}/tracks", "drawings/{id}/pages", "drawings/{id}/customer-answers"}
    assert without == {"/api/statistics", *(f"/api/{one}" for one in whole_documents)}
    for path in ("/api/tools", "/api/boards", "/api/profiles", "/api/library", "/api/machines"):
        # By name: the state of a machine may change between two requests.
        whole = [one["name"] for one in client.get(path).json()]
        found, url = [], f"{path}?limit=2"
        while url:
            answer = client.get(url)
            assert len(answer.json()) <= 2
            found += [one["name"] for one in answer.json()]
            link = answer.headers.get("Link", "")
            url = link[1:].partition(">")[0] if link else ""
        assert found == whole, path


def test_what_has_changed_since_a_time_is_listed(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())
    job = order_job(client, drawing["id"])
    client.patch(f"/api/drawings/{drawing['id']}", json={"notes": "later"})
    changed = client.get(f"/api/drawings/{drawing['id']}").json()
    assert changed["updated"] > drawing["updated"] >= drawing["created"]
    for path, one, since in (
        ("/api/drawings", drawing["id"], changed["updated"]),
        ("/api/jobs", job["id"], job["created"]),
    ):

        def ids(path: str = path, **times: str) -> list[str]:
            return [row["id"] for row in client.get(path, params=times).json()]

        assert one in ids(updated_after=since)
        assert one not in ids(updated_after="2999-01-01T00:00:00Z")
        assert one not in ids(updated_before=since[:4] + "-01-01T00:00:00Z")
        assert one in ids(created_after=drawing["created"])
        assert one not in ids(created_before=drawing["created"])
        backwards = {"updated_after": "2030-01-02T00:00:00Z", "updated_before": since}
        assert client.get(path, params=backwards).status_code == 422


@pytest.mark.parametrize("path", ["/api/history", "/api/statistics", "/api/audit"])
def test_a_period_that_ends_before_it_begins_is_refused(client: httpx.Client, path: str) -> None:
    period = {"since": "2030-01-02T00:00:00Z", "until": "2030-01-01T00:00:00Z"}
    answer = client.get(path, params=period)
    assert answer.status_code == 422
    assert "until must not be before since" in answer.json()["detail"]


def test_a_due_time_keeps_its_instant_or_is_refused(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing, due="2030-01-01T00:30:00+14:00")
    assert job["due"] == "2029-12-31T10:30:00.000Z"
    for due in ("0001-01-01T00:00:00+14:00", "9999-12-31T23:59:59-01:00", "0000-01-01T00:00:00Z"):
        order = {"drawing": drawing, "board": "e-flute", "due": due}
        assert client.post("/api/jobs", json=order).status_code == 422, due


def test_a_body_of_another_content_type_is_415(client: httpx.Client) -> None:
    body = json.dumps({"drawing": "x", "board": "e-flute"}).encode()
    for path, kind in (
        ("/api/jobs", None),
        ("/api/jobs", "application/octet-stream"),
        ("/api/webhooks", "application/xml"),
        ("/api/drawings", "application/json"),
        ("/api/orders", "image/png"),
        ("/api/orders", None),
        ("/api/keys", None),
    ):
        headers = {"X-Knifetip": "test", **({} if kind is None else {"Content-Type": kind})}
        answer = client.post(path, content=body, headers=headers)
        code = "request.no-media" if kind is None else "request.wrong-media"
        assert (answer.status_code, answer.json()["code"]) == (415, code), path
        assert ("no Content-Type" in answer.text) == (kind is None)
        assert "b'" not in answer.text
    headers = {"Content-Type": "application/vnd.shop+json; charset=utf-8"}
    assert client.post("/api/jobs", content=body, headers=headers).status_code == 404


def test_an_error_names_the_permitted_values_and_the_place(client: httpx.Client) -> None:
    answer = client.post("/api/machines/demo-table/operations", json={"operation": "x"}).json()
    for word in ("'x'", "unlock", "home", "jog"):
        assert word in answer["detail"]
    answer = client.get("/api/jobs?state=nothing").json()
    assert "queued" in answer["detail"]
    content = b'{"drawing": "a",\n "board": }'
    headers = {"Content-Type": "application/json"}
    answer = client.post("/api/jobs", content=content, headers=headers).json()
    assert answer["source"] == ["body"]
    assert "line 2, column 11" in answer["detail"]
    key = client.post("/api/jobs", json={}, headers=keyed("k" * 300)).json()
    assert "200 characters" in key["detail"]


HOSTILE: tuple[Any, ...] = (
    *(None, True, -1, 1.5, "x" * 300, [], {}, [[]], {"a": None}, "\x1b[0m", "é", 10**30),
)


def test_hostile_input_gets_no_words_of_python(
    client: httpx.Client, described: dict[str, Any]
) -> None:
    answers: list[tuple[str, httpx.Response]] = []
    names = {"name": "demo-table", "id": "none", "kind": "machines", "station": "1"}
    share = 4 if is_quick() else 1
    for number, (path, item) in enumerate(described["paths"].items()):
        url = path.format(**names, delivery="none", page="1", code="fefco-0427")
        for method in item:
            if method == "get" or "session" in url or "me/password" in url:
                continue
            # In `make test` each path gets another quarter of the bodies.
            for body in HOSTILE[number % share :: share]:
                answers.append((url, client.request(method, url, json=body)))
                wrapped = dict.fromkeys(("drawing", "operation", "url", "due", "name"), body)
                answers.append((url, client.request(method, url, json=wrapped)))
            for content, kind in (
                (b"{", "application/json"),
                (b'{"a": 1, "a": ' + b"9" * 5000 + b"}", "application/json"),
                (b"[" * 3000, "application/json"),
                (b"\xff\xfe", "application/json"),
                (b"a = [", "application/toml"),
                (b"--x", "multipart/form-data; boundary=x"),
                (b"PK\x03\x04damaged", "application/zip"),
                (b'<!DOCTYPE x SYSTEM "y"><x/>', "application/vnd.cip4-xjdf+xml"),
                (b"<x", "application/vnd.cip4-xjmf+xml"),
                (b'<?xml version="1.0" encoding="none"?><x/>', "application/vnd.cip4-xjdf+xml"),
            )[number % share :: share]:
                headers = {"Content-Type": kind}
                answers.append((url, client.request(method, url, content=content, headers=headers)))
    for url in ("http://a..b/", "http://[::1", "http://x:99999/", f"http://{'a' * 70}.de/"):
        answers.append((url, client.post("/api/webhooks", json={"url": url})))
    for query in ("cursor=x", "limit=0", "state=x", "since=x", "limit=1&limit=x", "metadata.=1"):
        for path in ("/api/jobs", "/api/history", "/api/audit", "/api/tools", "/api/statistics"):
            answers.append((path, client.get(f"{path}?{query}")))
    found = {
        (urlsplit(url).path, match[0], answer.json().get("detail", "")[:200])
        for url, answer in answers
        if answer.headers.get("content-type") == "application/problem+json"
        and (match := PYTHON.search(answer.json()["detail"] + answer.json()["hint"]))
    }
    assert found == set()
    assert [url for url, answer in answers if answer.status_code == 500] == []


def test_a_cookie_without_a_sign_of_the_page_is_refused() -> None:
    facts = RequestFacts(
        method="POST",
        path="/api/jobs/a/release",
        scheme="http",
        host="127.0.0.1:8080",
        peer="127.0.0.1",
        server=("127.0.0.1", 8080),
        agent="curl/8.5.0",
        user_session="token",
    )
    refused = find_access(AccessRules(loopback_only=True), facts, 0.0)
    assert isinstance(refused, Refusal)
    assert (refused.status, refused.message.code) == (403, "request.not-marked")


def test_a_drawing_on_another_host_is_refused(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]

    def order(url: str) -> httpx.Response:
        text = (
            '<XJDF xmlns="http://www.CIP4.org/JDFSchema_2_0" JobID="J1" Types="Cutting">'
            '<ResourceSet Name="DieLayout" Usage="Input"><Resource><DieLayout>'
            f'<FileSpec URL="{url}"/></DieLayout></Resource></ResourceSet></XJDF>'
        )
        return client.post(
            "/api/xjdf?machine=demo-table&board=e-flute",
            content=text.encode(),
            headers={"Content-Type": "application/vnd.cip4-xjdf+xml"},
        )

    refused = order(f"http://evil.example/api/v1/drawings/{drawing}")
    assert (refused.status_code, refused.json()["code"]) == (422, "xjdf.foreign-drawing")
    own = str(client.base_url).rstrip("/")
    assert order(f"{own}/api/v1/drawings/{drawing}").status_code == 201
    assert order(f"/api/v1/drawings/{drawing}").status_code == 201


def test_a_field_of_several_types_is_named_as_the_client_sent_it(client: httpx.Client) -> None:
    drawing = {"file": ("tray.dxf", b"")}
    wrong = client.post("/api/drawings", files=drawing, data={"unit": "parsec", "due": "never"})
    assert wrong.json()["source"] == ["body.unit", "body.due"]
    long = client.post("/api/jobs", json={}, headers={"Idempotency-Key": "k" * 201})
    assert "header.Idempotency-Key" in long.json()["source"]
    for answer in (wrong, long):
        assert answer.status_code == 422
        assert "literal" not in answer.text
        assert "constrained" not in answer.text
