"""Metrics of a server: true numbers, and labels that no request can multiply."""

from __future__ import annotations

import re
import uuid
from pathlib import Path

import httpx
import pytest
from prometheus_client.parser import text_string_to_metric_families

from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.monitoring.measures import measure
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.serving.server import (
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("server")


def scrape(client: httpx.Client) -> dict[tuple[str, tuple[tuple[str, str], ...]], float]:
    """Return the value of each sample by name and sorted labels."""
    answer = client.get("/metrics")
    assert answer.status_code == 200, answer.text
    assert answer.headers["Content-Type"].startswith("text/plain; version=0.0.4")
    return {
        (sample.name, tuple(sorted(sample.labels.items()))): sample.value
        for family in text_string_to_metric_families(answer.text)
        for sample in family.samples
    }


def test_the_metrics_count_requests_jobs_gateways_and_stages(tmp_path: Path) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        job = order_job(client, upload_drawing(client, square())["id"])["id"]
        wait_for_state(client, job, "ready")
        other = upload_drawing(client, square(side=120.0))["id"]
        released = order_job(client, other, release=True)["id"]
        ask = {"gateway": "g", "machine": "demo-table", "wait": 50}
        claim = client.post("/api/v1/gateway/claim", json=ask).json()
        assert claim["job"] == released
        client.get(f"/api/v1/jobs/{job}")
        found = scrape(client)

        def value(name: str, **labels: str) -> float:
            return found[f"knifetip_{name}", tuple(sorted(labels.items()))]

        created = {"method": "POST", "route": "/api/drawings", "status": "201"}
        assert value("requests_total", **created) == 2
        claims = {"method": "POST", "route": "/api/gateway/claim", "status": "200"}
        assert value("requests_total", **claims) == 1
        assert value("request_seconds_count", method="POST", route="/api/drawings") == 2
        assert value("jobs", machine="demo-table", state="ready") == 1
        assert 0 <= value("gateway_silent_seconds", machine="demo-table") < 60
        assert value("compile_stage_seconds_count", stage="verify") == 2
        assert value("compile_stage_seconds_sum", stage="verify") > 0
        assert value("database_available") == 1
        assert value("processes") == 2
        assert value("event_listeners") == 0
        assert value("webhook_deliveries_pending") == 0
        assert value("leases_expired_total") == 0


def test_no_request_can_multiply_the_labels(tmp_path: Path) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        scrape(client)

        def request_all() -> None:
            for _ in range(20):
                name = uuid.uuid4().hex
                client.get(f"/api/jobs/{name}")
                client.get(f"/{name}")
                client.get(f"/api/{name}?{name}={name}")
                client.request(name.upper(), "/api/jobs")
                client.get("/api/jobs", headers={"Host": f"{name}.example"})

        request_all()
        first = set(scrape(client))
        request_all()
        assert set(scrape(client)) == first
        text = client.get("/metrics").text
        assert re.search("[0-9a-f]{32}", text) is None
        assert 'route="/api/jobs/{id}"' in text


def test_many_machines_count_as_one_other(database_url: str) -> None:
    store = Store(database_url)
    store.prepare()
    found = measure(store.database, 3)
    assert (found.jobs, found.silent, found.deliveries) == ({}, {}, 0)
    for number in range(5):
        store.machines.record_contact(f"m{number}", "g")
    assert len(measure(store.database, 3).silent) == 3
    store.close()


def test_metrics_need_access(tmp_path: Path) -> None:
    rules = AccessRules(key="correct-horse-battery", hosts=("shop.example",))
    settings = Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")
    with run_server(settings, rules) as client:
        # A request that the server cannot attribute to this computer.
        far = {"Host": "shop.example", "X-Forwarded-For": "192.0.2.7"}
        assert client.get("/metrics", headers=far).status_code == 401
        key = {"Authorization": "Bearer correct-horse-battery"}
        assert client.get("/metrics", headers={**far, **key}).status_code == 200
