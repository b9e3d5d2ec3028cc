"""Any request gets a response or a problem document, and never an internal error."""

from __future__ import annotations

import contextlib
import itertools
import json
import threading
import time
from collections.abc import Iterator
from typing import Any, NoReturn

import httpx
import pytest
import sqlalchemy.exc

from knifetip import errors
from knifetip.service.orders.store import JobStore
from knifetip.service.processes.warm_up import WarmUp, WarmUpProgress
from knifetip.service.refusals.error_status import status_of
from tests.support.serving.server import square, upload_drawing

pytestmark = pytest.mark.xdist_group("server")

PROBLEM = "application/problem+json"
HUGE = "9" * 5000
PNG = b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 40


def problem(answer: httpx.Response, status: int) -> dict[str, Any]:
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == PROBLEM
    data: dict[str, Any] = answer.json()
    assert data["status"] == status
    assert data["title"]
    assert data["detail"]
    assert "Traceback" not in answer.text
    return data


def upload(client: httpx.Client, content: bytes, name: str = "a.dxf") -> httpx.Response:
    return client.post("/api/drawings", files={"file": (name, content)})


@pytest.mark.parametrize(
    "content",
    [
        b"",
        PNG,
        b"\0" * 5000,
        b"%PDF-1.7\n",
        b"hello",
        b"AutoCAD Binary DXF\r\n\x1a\x00" + b"\xff" * 500,
        b"0\nSECTION\n2\nENTITIES\n" * 200,
        b"999\n" * 3000,
        square()[: len(square()) // 2],
    ],
    ids=range(9),
)
def test_a_file_that_is_no_drawing_is_a_problem_that_names_it(
    client: httpx.Client, content: bytes
) -> None:
    data = problem(upload(client, content), 422)
    assert "a.dxf" in data["detail"]
    assert data["hint"]


def test_entities_without_a_finite_place_are_dropped_with_a_reason(client: httpx.Client) -> None:
    answer = upload(client, square().replace(b"100.0", b"1e999"))
    assert answer.status_code == 201
    assert answer.json()["bounds"] == [0.0] * 4
    report = answer.json()["import_report"]
    assert (report["kept"], report["dropped"]) == (0, 4)
    reasons = [row["reason"]["code"] for row in report["rows"]]
    assert reasons == ["import.coordinate-not-a-number"] * 4


def test_70_megabytes_are_refused_before_they_are_read(client: httpx.Client) -> None:
    data = problem(upload(client, b"0\n" * (35 << 20)), 413)
    assert "64 MB" in data["detail"]


def test_70_megabytes_without_a_length_are_refused(
    client: httpx.Client,
) -> None:
    taken = 0

    def parts() -> Iterator[bytes]:
        nonlocal taken
        yield b'--x\r\nContent-Disposition: form-data; name="file"; filename="a.dxf"\r\n\r\n'
        for _ in range(200):
            taken += 1
            yield b"0\n" * (1 << 19)
        yield b"\r\n--x--\r\n"

    # The server responds and disconnects while the client sends: either may be seen first.
    with contextlib.suppress(httpx.WriteError, httpx.RemoteProtocolError):
        answer = client.post(
            "/api/drawings",
            content=parts(),
            headers={"Content-Type": "multipart/form-data; boundary=x"},
        )
        problem(answer, 413)
    assert 64 <= taken < 100


def test_an_order_of_17_megabytes_is_refused_too(client: httpx.Client) -> None:
    data = {"drawing": "x" * (17 << 20), "board": "e-flute"}
    assert "16 MB" in problem(client.post("/api/jobs", json=data), 413)["detail"]


def test_a_page_of_another_site_cannot_order_anything(client: httpx.Client) -> None:
    answer = client.post("/api/jobs", json={}, headers={"Sec-Fetch-Site": "cross-site"})
    problem(answer, 403)


def test_a_rebound_name_cannot_read_anything(client: httpx.Client) -> None:
    for path in ("/", "/api/jobs", "/api/events", "/healthz"):
        problem(client.get(path, headers={"Host": "rebound.example"}), 421)


@pytest.mark.parametrize("path", ["/api/jobs", "/api/nothing", "/healthz"])
def test_responses_cannot_be_framed_executed_or_sniffed(client: httpx.Client, path: str) -> None:
    headers = client.get(path).headers
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["x-frame-options"] == "DENY"
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    assert headers["cross-origin-resource-policy"] == "same-origin"


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [
        ("GET", "/api/nothing", 404),
        ("POST", "/api/nothing", 404),
        ("GET", "/api/jobs/nothing", 404),
        ("GET", "/api/drawings/%00", 422),
        ("GET", "/api/drawings/" + "x" * 3000, 404),
        ("GET", "/api/drawings/..%2f..%2fetc%2fpasswd", 404),
        ("GET", "/api/machines/nothing", 404),
        ("GET", "/api/boards/%2Fetc%2Fx.toml", 404),
        ("GET", "/api/profiles/nothing", 404),
        ("DELETE", "/api/jobs", 405),
        ("PUT", "/api/drawings", 405),
        ("POST", "/index.html", 405),
        ("GET", "/api/jobs?state=nonsense", 422),
        ("GET", "/api/jobs?limit=0", 422),
        ("GET", f"/api/jobs?cursor={HUGE}", 422),
        ("GET", f"/api/jobs?limit={HUGE}", 422),
        ("GET", "/api/drawings?cursor=%F0%28%8C", 422),
        ("GET", f"/api/events?after={HUGE}", 422),
    ],
)
def test_a_wrong_address_is_a_problem(
    client: httpx.Client, method: str, path: str, status: int
) -> None:
    problem(client.request(method, path), status)


HOSTILE: list[object] = [
    None,
    [],
    {},
    "text",
    0,
    -1,
    1e308,
    float("nan"),
    float("-inf"),
    10**40,
    True,
    "x" * 100_000,
    "\0",
    "\ud800",
    "'; DROP TABLE job; --",
    "../../../etc/passwd",
    [[[[]]]],
    {"$ref": "#"},
    [None] * 1000,
]


def body(fields: dict[str, object]) -> bytes:
    return json.dumps(fields).encode()


BODIES: dict[str, dict[str, Any]] = {
    "/api/jobs": {
        "drawing": "nothing",
        "machine": "demo-table",
        "board": "e-flute",
        "profile": "default",
        "copies": 1,
        "priority": 0,
        "overrides": [],
        "release": False,
    },
    "/api/jobs/nothing/confirm": {"checked": ["board"], "by": "Kim"},
    "/api/gateway/claim": {"gateway": "g", "machine": "demo-table", "wait": 0.0},
    "/api/gateway/heartbeat": {
        "job": "nothing",
        "epoch": 1,
        "line": 1,
        "copies_done": 0,
        "held": False,
        "waiting": False,
        "position": [0.0, 0.0, 0.0, 0.0],
        "seconds_left": 1.0,
    },
    "/api/gateway/finish": {
        "job": "nothing",
        "epoch": 1,
        "outcome": "done",
        "why": "",
        "line": 1,
        "copies_done": 0,
    },
}


@pytest.mark.parametrize("path", BODIES)
def test_no_body_causes_an_internal_error(client: httpx.Client, path: str) -> None:
    plain = BODIES[path]
    for field, value in itertools.product(plain, HOSTILE):
        data = body({**plain, field: value})
        answer = client.post(path, content=data, headers={"Content-Type": "application/json"})
        assert answer.status_code < 500, (field, value, answer.text)
        if answer.status_code >= 400:
            problem(answer, answer.status_code)


@pytest.mark.parametrize("where", ["", "/edges"])
def test_no_change_to_a_drawing_causes_an_internal_error(client: httpx.Client, where: str) -> None:
    id = upload_drawing(client, square())["id"]
    fields = ["unit", "profile"] if not where else ["type", "edges", "handles", "layer", "colour"]
    for field, value in itertools.product(fields, HOSTILE):
        data: dict[str, object] = {field: value}
        if where:
            data = {"overrides": [{"type": "cut", **data}]}
        answer = client.patch(
            f"/api/drawings/{id}{where}",
            content=body(data),
            headers={"Content-Type": "application/json"},
        )
        assert answer.status_code < 500, (field, value, answer.text)
    assert client.get(f"/api/drawings/{id}").json()["segments"] == 4


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"{",
        b"NaN",
        b"\xff\xfe\x00",
        b"[" * 100_000,
        b'{"drawing":' * 20_000,
        b'{"drawing": "a", "drawing": "b"}',
        b"null",
    ],
    ids=range(8),
)
@pytest.mark.parametrize("path", BODIES)
def test_invalid_json_is_a_problem(client: httpx.Client, path: str, raw: bytes) -> None:
    answer = client.post(path, content=raw, headers={"Content-Type": "application/json"})
    # A confirmation needs no body; without one, the only error is that the job does not exist.
    absent = path.endswith("/confirm") and raw in (b"", b"null")
    assert answer.status_code in ((404,) if absent else (400, 422))
    problem(answer, answer.status_code)


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (b"", "multipart/form-data"),
        (b"", "multipart/form-data; boundary=x"),
        (b"--x\r\n\r\n--x--", "multipart/form-data; boundary=x"),
        (
            b'--x\r\nContent-Disposition: form-data; name="file"\r\n\r\nhi\r\n--x--\r\n',
            "multipart/form-data; boundary=x",
        ),
        (b"{}", "application/json"),
        (b"file=1", "application/x-www-form-urlencoded"),
    ],
    ids=range(6),
)
def test_a_form_without_a_file_is_a_problem(
    client: httpx.Client, content: bytes, kind: str
) -> None:
    answer = client.post("/api/drawings", content=content, headers={"Content-Type": kind})
    # Requests that any page can send as a plain form are refused before they are read.
    assert answer.status_code in ((400, 422) if kind.startswith("multipart") else (415,))
    problem(answer, answer.status_code)


def test_an_invalid_field_is_reported_with_its_path(client: httpx.Client) -> None:
    order = {"drawing": "a", "board": "e-flute", "overrides": [{"type": "kut", "edges": [0]}]}
    data = problem(client.post("/api/jobs", json=order), 422)
    assert data["source"] == ["body.overrides.0.type"]
    assert "body.overrides.0.type" in data["detail"]
    (fault,) = data["arguments"]["faults"]
    assert fault["code"] == "field.not-one-of"
    assert "'half-cut'" in fault["arguments"]["known"]


@pytest.mark.parametrize(
    ("changed", "code"),
    [
        ({"drawing": None}, "field.not-text"),
        ({"drawing": ""}, "field.too-short"),
        ({"drawing": "a" * 201}, "field.too-long"),
        ({"copies": "many"}, "field.not-whole"),
        ({"copies": 0}, "field.below"),
        ({"priority": 101}, "field.above"),
        ({"overrides": {}}, "field.not-a-list"),
        ({"overrides": [1]}, "field.not-a-table"),
        ({"corners": {"k": "x"}}, "field.not-a-number"),
        ({"corners": {"k": 0.0}}, "field.not-above"),
        ({"corners": {"k": 1.0}}, "field.not-below"),
        ({"corners": {"type": "E"}}, "field.not-one-of"),
        ({"corners": {"at": [{"x": 0.0, "y": 0.0, "type": "C"}] * 1001}}, "field.too-many"),
        ({"release": "maybe"}, "field.not-boolean"),
        ({"colour": "red"}, "field.unknown"),
    ],
)
def test_every_fault_of_a_request_has_a_code(
    client: httpx.Client, changed: dict[str, Any], code: str
) -> None:
    order = {"drawing": "a", "board": "e-flute"} | changed
    data = problem(client.post("/api/jobs", json=order), 422)
    assert [fault["code"] for fault in data["arguments"]["faults"]][:1] == [code]
    assert "Input should" not in data["detail"]


def test_a_request_that_is_not_json_has_a_code(client: httpx.Client) -> None:
    headers = {"Content-Type": "application/json"}
    data = problem(client.post("/api/jobs", content=b"{", headers=headers), 422)
    assert [fault["code"] for fault in data["arguments"]["faults"]] == ["field.bad-json"]


def test_every_error_has_a_status_and_none_is_an_internal_error() -> None:
    def descendants(kind: type[errors.KnifetipError]) -> list[type[errors.KnifetipError]]:
        return [kind, *(deep for child in kind.__subclasses__() for deep in descendants(child))]

    kinds = descendants(errors.KnifetipError)
    made = [kind.__new__(kind) for kind in kinds]
    assert len(made) > 20
    assert {status_of(error) for error in made} == {
        401,
        403,
        404,
        409,
        412,
        413,
        415,
        422,
        429,
        502,
        503,
    }


def test_openapi_is_3_1_and_every_route_declares_its_problems(
    client: httpx.Client,
) -> None:
    described = client.get("/api/openapi.json").json()
    assert described["openapi"].startswith("3.1")
    operations = [operation for path in described["paths"].values() for operation in path.values()]
    assert len({operation["operationId"] for operation in operations}) == len(operations) > 30
    for operation in operations:
        problems = {
            status: response["content"][PROBLEM]["schema"]
            for status, response in operation["responses"].items()
            if status[0] in "45" and PROBLEM in response["content"]
        }
        assert {"400", "429", "500", "503"} <= set(problems)
        for answer in problems.values():
            assert answer == {"$ref": "#/components/schemas/Problem"}
    text = json.dumps(described)
    assert "HTTPValidationError" not in text
    referred = {part.split('"')[0] for part in text.split("#/components/schemas/")[1:]}
    assert referred <= set(described["components"]["schemas"])


def test_no_two_models_have_the_same_name(client: httpx.Client) -> None:
    described = client.get("/api/openapi.json").json()
    # FastAPI puts the module before the names of models that have the same name.
    assert [name for name in described["components"]["schemas"] if "__" in name] == []


def test_openapi_describes_every_property_and_every_parameter(client: httpx.Client) -> None:
    described = client.get("/api/openapi.json").json()
    properties = {
        f"{name}.{field}": schema
        for name, model in described["components"]["schemas"].items()
        for field, schema in model.get("properties", {}).items()
    }
    parameters = {
        f"{method} {path} {parameter['name']}": parameter
        for path, operations in described["paths"].items()
        for method, operation in operations.items()
        for parameter in operation.get("parameters", [])
    }
    assert len(properties) > 300
    assert len(parameters) > 40
    bare = [
        name
        for name, schema in {**properties, **parameters}.items()
        if not schema.get("description", "").strip()
    ]
    assert bare == []


def test_health_and_readiness(client: httpx.Client) -> None:
    assert client.get("/healthz").json()["status"] == "ok"
    checks = {"database": "ok", "schema": "ok", "contents": "ok", "disk": "ok", "workers": "ok"}
    assert client.get("/readyz").json()["checks"] == checks


def test_an_upload_waits_for_its_kernels_while_the_server_answers(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[tuple[str, ...]] = []
    compiled = threading.Event()

    def wait(_warm_up: WarmUp, *groups: str) -> None:
        asked.append(groups)
        assert compiled.wait(20.0)

    monkeypatch.setattr(WarmUp, "wait", wait)
    answers: list[int] = []
    thread = threading.Thread(
        target=lambda: answers.append(upload(client, square()).status_code), daemon=True
    )
    thread.start()
    while not asked:
        time.sleep(0.01)
    assert client.get("/readyz").status_code == 200
    assert answers == []
    compiled.set()
    thread.join(30.0)
    assert answers == [201]
    assert asked == [("drawings",)]


def test_the_service_reports_its_preparation(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(WarmUp, "progress", WarmUpProgress(False, 43, 240))
    status = client.get("/api/service").json()
    assert {**status, "version": ""} == {
        "version": "",
        "preparing": True,
        "parts_compiled": 43,
        "parts": 240,
    }


def test_a_body_that_is_not_multipart_is_a_problem_with_a_code(client: httpx.Client) -> None:
    headers = {"Content-Type": "multipart/form-data"}  # without a boundary
    data = problem(client.post("/api/drawings", content=b"hello", headers=headers), 400)
    assert data["code"] == "request.body-unreadable"


def test_a_server_without_a_free_connection_to_its_database_answers_503(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    def get(_store: JobStore, _id: str) -> NoReturn:
        raise sqlalchemy.exc.TimeoutError("QueuePool limit of size 10 overflow 40 reached")

    monkeypatch.setattr(JobStore, "get", get)
    answer = client.get("/api/jobs/abc")
    assert answer.status_code == 503
    assert answer.json()["code"] == "server.database-silent"


@pytest.mark.parametrize(
    ("path", "allowed"),
    [
        ("/api/webhooks", "GET, HEAD, POST"),
        ("/api/v1/jobs", "GET, HEAD, POST"),
        ("/api/drawings/some", "DELETE, GET, HEAD, PATCH"),
        ("/index.html", "GET, HEAD"),
    ],
)
def test_a_refused_method_names_every_method_of_the_path(
    client: httpx.Client, path: str, allowed: str
) -> None:
    answer = client.request("OPTIONS", path)
    assert answer.status_code == 405
    assert answer.headers["Allow"] == allowed
