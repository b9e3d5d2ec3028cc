"""Each request has an id and one record; hostile names act neither in logs nor in headers."""

from __future__ import annotations

import io
import json
import logging
import re
import time
from collections.abc import Iterator
from itertools import islice
from typing import Any

import httpx
import pytest

from knifetip import logs
from knifetip.logs import LogFormat, LogLevel
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.settings import Settings
from tests.support.command import Command
from tests.support.hostile_names import HOSTILE_NAMES, acting
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")
KEY = "correct-horse-battery-staple"


@pytest.fixture(scope="module")
def stream() -> Iterator[io.StringIO]:
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    stream = io.StringIO()
    logs.configure(LogFormat.JSON, LogLevel.INFO, stream)
    yield stream
    logging.captureWarnings(False)
    root.handlers[:] = handlers
    root.setLevel(level)


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory, stream: io.StringIO) -> Iterator[LocalClient]:
    rules = AccessRules(key=KEY, loopback_only=True)
    database = f"sqlite:///{tmp_path_factory.mktemp('log')}/a.sqlite"
    with run_server(Settings(database=database, name="test"), rules) as one:
        yield one


def record_of(stream: io.StringIO, answer: httpx.Response) -> dict[str, Any]:
    """Wait for the record of an answered request, which is written after the answer."""
    for _ in range(1000):
        for line in stream.getvalue().splitlines():
            record: dict[str, Any] = json.loads(line)
            if record.get("request_id") == answer.headers["X-Request-ID"]:
                return record
        time.sleep(0.02)
    raise AssertionError(f"no record of {answer.request.url}")


def test_a_request_has_one_record_with_its_id_principal_subject_and_duration(
    client: LocalClient, stream: io.StringIO
) -> None:
    answer = client.post(
        "/api/v1/drawings",
        files={"file": ("a.dxf", square())},
        headers={"X-Request-ID": "erp-42.a_B"},
    )
    assert answer.headers["X-Request-ID"] == "erp-42.a_B"
    record = record_of(stream, answer)
    assert record["logger"] == "knifetip.access"
    assert record["message"] == "POST /api/v1/drawings"
    assert (record["method"], record["status"]) == ("POST", 201)
    assert record["drawing"] == answer.json()["id"]
    assert record["principal"] == "local"
    assert 0.0 < record["duration"] < 60.0
    assert stream.getvalue().count("erp-42.a_B") == 1


@pytest.mark.parametrize("id", [b"a b", b"a;b", b"x" * 65, b"\xe9", b""])
def test_an_id_that_is_not_harmless_is_replaced(
    client: LocalClient, stream: io.StringIO, id: bytes
) -> None:
    answer = client.get("/api/jobs", headers={b"X-Request-ID": id})
    assert re.fullmatch("[0-9a-f]{32}", answer.headers["X-Request-ID"])
    assert record_of(stream, answer)["status"] == 200


def test_refused_requests_have_an_id_and_a_record_without_the_key(
    client: LocalClient, stream: io.StringIO
) -> None:
    refused = client.get("/api/jobs", headers={"Host": "evil.example"})
    assert refused.status_code == 421
    assert record_of(stream, refused)["status"] == 421
    for answer in (
        client.get(f"/?key={KEY}"),
        client.get("/api/jobs", headers={"Authorization": f"Bearer {KEY}"}),
        client.get("/api/jobs", headers={"Cookie": f"knifetip={KEY}"}),
        client.get("/api/jobs", headers={"X-Request-ID": f"key={KEY}"}),
    ):
        assert record_of(stream, answer)
    client.cookies.clear()  # the address with the key has signed this client in
    assert KEY not in stream.getvalue()


@pytest.mark.parametrize("name", HOSTILE_NAMES.values(), ids=HOSTILE_NAMES.keys())
def test_a_hostile_name_is_harmless_in_answers_headers_and_the_log(
    client: LocalClient, stream: io.StringIO, name: str
) -> None:
    sent = name.encode("utf-8", "replace").decode()
    uploaded = client.post("/api/drawings", files={"file": (sent, square())})
    answer = uploaded
    if uploaded.status_code == 422:
        assert uploaded.json()["source"] == ["body.file.filename"]
        assert acting(uploaded.text) == set()
    else:
        assert uploaded.status_code == 201, uploaded.text
        drawing = uploaded.json()
        assert acting(drawing["name"]) == set()
        answer = client.get(f"/api/drawings/{drawing['id']}/file")
    for value in answer.headers.values():
        assert acting(value) == set()
        assert value.isascii()
    record_of(stream, answer)
    lines = stream.getvalue().splitlines()
    assert all(isinstance(json.loads(line), dict) for line in lines)
    assert acting(stream.getvalue(), permitted="\n") == set()


def test_hostile_names_are_harmless_in_the_terminal(client: LocalClient, knifetip: Command) -> None:
    # Each compile takes a while; the names are stored alike.
    for name in islice(filter(str.isprintable, HOSTILE_NAMES.values()), 0, None, 3):
        sent = name.encode("utf-8", "replace").decode()
        id = client.post("/api/drawings", files={"file": (sent, square())}).json()["id"]
        job = order_job(client, id)["id"]
        wait_for_state(client, job, "ready")
        code, out, err = knifetip("job", "show", job, "--server", str(client.base_url))
        assert code == 0, err
        assert acting(out + err, permitted="\n") == set()
        download = client.get(f"/api/jobs/{job}/program")
        disposition = download.headers.get("Content-Disposition", "")
        assert re.fullmatch(r'attachment; filename="[A-Za-z0-9._-]+"', disposition)
