"""Metrics at an address of their own: without a key, of server, worker and gateway."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
import pytest
from prometheus_client import CollectorRegistry, Counter
from prometheus_client.parser import text_string_to_metric_families

from knifetip.errors import StoreError
from knifetip.gateway.metrics import RunMetrics
from knifetip.metrics_server import serve_metrics


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return int(one.getsockname()[1])


def samples(port: int) -> dict[str, float]:
    answer = httpx.get(f"http://127.0.0.1:{port}/metrics")
    assert answer.status_code == 200
    families = text_string_to_metric_families(answer.text)
    return {
        f"{sample.name}{sorted(sample.labels.items())}": sample.value
        for family in families
        for sample in family.samples
    }


@contextmanager
def process(*words: object) -> Iterator[subprocess.Popen[str]]:
    started = subprocess.Popen(
        [sys.executable, "-m", "knifetip.cli", *map(str, words)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield started
    finally:
        started.terminate()
        started.communicate(timeout=30)


def wait_for_metrics(port: int, running: subprocess.Popen[str]) -> dict[str, float]:
    deadline = time.monotonic() + 120.0
    while time.monotonic() < deadline:
        assert running.poll() is None
        try:
            return samples(port)
        except httpx.TransportError:
            time.sleep(0.1)
    raise AssertionError("no metrics")


def test_an_address_answers_until_it_is_closed() -> None:
    registry = CollectorRegistry()
    counter = Counter("knifetip_things", "Things.", registry=registry)
    counter.inc(3)
    port = free_port()
    with serve_metrics(f"127.0.0.1:{port}", registry):
        assert samples(port)["knifetip_things_total[]"] == 3
        with pytest.raises(StoreError, match="in use"):
            serve_metrics(f"127.0.0.1:{port}", registry)
    with pytest.raises(httpx.TransportError):
        samples(port)


@pytest.mark.parametrize("address", ["9464", "host", "host:", ":9464", "host:99999", "[::1:9464"])
def test_other_addresses_are_refused(address: str) -> None:
    with pytest.raises(StoreError) as caught:
        serve_metrics(address, CollectorRegistry())
    assert "HOST:PORT" in caught.value.hint


def test_runs_of_a_gateway_are_counted_by_outcome() -> None:
    metrics = RunMetrics("demo-table")
    metrics.observe("done", 42.0)
    metrics.observe("interrupted", 1.0)
    runs = {
        (sample.labels["outcome"], sample.value)
        for family in metrics.registry.collect()
        for sample in family.samples
        if sample.name == "knifetip_gateway_runs_total"
    }
    assert runs == {("done", 1.0), ("interrupted", 1.0)}


def test_a_worker_and_a_gateway_are_scraped(tmp_path: Path) -> None:
    port, second = free_port(), free_port()
    database = f"sqlite:///{tmp_path}/shop.sqlite"
    with (
        process(
            *("worker", "--database", database, "--metrics-address", f"127.0.0.1:{port}")
        ) as worker,
        process(
            *("gateway", "--server", "http://127.0.0.1:1", "--controller", "127.0.0.1:1"),
            *("--journal", tmp_path / "journal", "--metrics-address", f"127.0.0.1:{second}"),
        ) as gateway,
    ):
        found = wait_for_metrics(port, worker)
        assert found["knifetip_processes[]"] == 1
        assert found["knifetip_database_available[]"] == 1
        assert found["knifetip_compile_seconds_count[]"] == 0
        runs = wait_for_metrics(second, gateway)
        assert runs["knifetip_gateway_run_seconds_count[('machine', 'demo-table')]"] == 0


def test_a_server_is_scraped_without_a_key_at_that_address(tmp_path: Path) -> None:
    port = free_port()
    database = f"sqlite:///{tmp_path}/shop.sqlite"
    words = ("serve", "--port", 0, "--no-samples", "--no-simulator", "--database", database)
    with process(*words, "--metrics-address", f"127.0.0.1:{port}") as server:
        assert "knifetip_compile_seconds_count[]" in wait_for_metrics(port, server)
