"""A client has limits of its own, and requests of gateways have none."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import pytest

from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.clients import TokenBuckets, network_of
from knifetip.service.settings import Settings
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
)

pytestmark = pytest.mark.xdist_group("limits")


def settings(folder: Path, **limits: Any) -> Settings:
    return Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test", **limits)


def test_tokens_return_with_time_up_to_the_size_of_the_bucket() -> None:
    now = 100.0
    buckets = TokenBuckets(2.0, 3, lambda: now)
    assert [buckets.take("a") for _ in range(4)] == [2.0, 1.0, 0.0, -1.0]
    assert buckets.take("b") == 2.0
    now = 100.25  # half a token is back, one more is needed
    assert buckets.take("a") == -0.5
    now = 100.5
    assert buckets.take("a") == 0.0
    now = 1000.0
    assert buckets.take("a") == 2.0


def test_requests_beyond_the_rate_are_refused_with_a_time_to_retry(tmp_path: Path) -> None:
    with run_server(settings(tmp_path, max_rate=1, max_burst=20)) as client:
        first = client.get("/api/jobs")
        assert first.status_code == 200
        assert first.headers["RateLimit-Policy"] == '"client";q=20;w=20'
        assert first.headers["RateLimit"].startswith('"client";r=19;')
        answers = [client.get("/api/v1/jobs") for _ in range(60)]
        refused = [one for one in answers if one.status_code != 200]
        # 19 of the bucket, and one more for each second that the 60 requests took.
        assert 20 <= len(refused) <= 41
        assert {one.status_code for one in refused} == {429}
        assert refused[0].headers["Retry-After"] == "1"
        assert refused[0].json()["code"] == "limit.too-many-requests"


def test_gateways_and_health_checks_are_not_limited(tmp_path: Path) -> None:
    with run_server(settings(tmp_path, max_rate=1, max_burst=3)) as client:
        drawing = upload_drawing(client, square())
        job = order_job(client, drawing["id"], release=True)["id"]
        ask = {"gateway": "g", "machine": "demo-table", "wait": 50}
        claim = client.post("/api/gateway/claim", json=ask).json()
        while client.get("/api/jobs").status_code != 429:
            pass
        beat = {"job": job, "epoch": claim["epoch"], "line": 1}
        answers = [client.post("/api/gateway/heartbeat", json=beat) for _ in range(20)]
        assert {one.status_code for one in answers} == {200}
        assert {client.get("/healthz").status_code for _ in range(20)} == {200}


def test_refused_requests_are_limited_and_do_not_use_up_the_rate_of_others(tmp_path: Path) -> None:
    with run_server(settings(tmp_path, max_rate=1, max_burst=3)) as client:
        foreign = {"Origin": "https://evil.example"}
        statuses = [client.post("/api/jobs", headers=foreign).status_code for _ in range(8)]
        assert statuses[:3] == [403] * 3
        assert statuses.count(429) >= 3
        assert client.get("/api/jobs").status_code == 200
        assert client.get("/healthz").status_code == 200


def test_requests_to_routes_of_gateways_are_limited_for_others(tmp_path: Path) -> None:
    with run_server(settings(tmp_path, max_rate=1, max_burst=3)) as client:
        secret = client.service.store.keys.add("screen", [AccessScope.VIEWER])[1]
        headers = {"Authorization": f"Bearer {secret}"}
        answers = [
            client.get("/api/gateway/program/none", headers=headers).status_code for _ in range(60)
        ]
    assert answers[0] == 403
    assert 429 in answers


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("192.0.2.7", "192.0.2.7"),
        ("2001:db8::1", "2001:db8::/64"),
        ("2001:db8::ffff:1:2", "2001:db8::/64"),
        ("2001:db8:0:1::1", "2001:db8:0:1::/64"),
        ("fe80::1%eth0", "fe80::/64"),
        ("::ffff:192.0.2.7", "192.0.2.7"),
        ("testclient", "testclient"),
        ("", ""),
    ],
)
def test_a_computer_has_one_network(host: str, expected: str) -> None:
    assert network_of(host) == expected


def listen(client: LocalClient, count: int, use: threading.Barrier) -> list[threading.Thread]:
    """Open streams of events that stay open until ``use`` is passed a second time."""

    def listen() -> None:
        with client.stream("GET", "/api/events") as answer:
            assert answer.status_code == 200
            lines = answer.iter_lines()  # closes the connection when it is deleted
            next(lines)
            use.wait(20)
            use.wait(20)

    threads = [threading.Thread(target=listen) for _ in range(count)]
    for one in threads:
        one.start()
    return threads


@pytest.mark.parametrize(
    ("limits", "status"),
    [({"max_listeners": 2}, 429), ({"max_all_listeners": 2}, 503)],
    ids=["one-client", "all-clients"],
)
def test_listeners_beyond_the_limit_are_refused_until_one_leaves(
    tmp_path: Path, limits: dict[str, int], status: int
) -> None:
    with run_server(settings(tmp_path, **limits)) as client:
        both = threading.Barrier(3)
        threads = listen(client, 2, both)
        both.wait(20)
        refused = client.get("/api/events")
        assert refused.status_code == status
        assert refused.json()["code"] == "limit.too-many-listeners"
        assert "Retry-After" in refused.headers
        both.wait(20)
        for one in threads:
            one.join()
        answered = 0
        for _ in range(200):  # the server detects a closed connection a moment later
            with client.stream("GET", "/api/events") as answer:
                answered = answer.status_code
            if answered == 200:
                break
        assert answered == 200
