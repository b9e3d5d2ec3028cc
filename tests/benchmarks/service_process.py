"""Processes of a service that is measured, and requests whose durations are recorded."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import httpx


def free_port() -> int:
    """Return a free TCP port of this computer."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextmanager
def run_process(*words: object) -> Iterator[subprocess.Popen[bytes]]:
    """Run ``python -m`` with some words in a process group of its own."""
    command = [sys.executable, "-m", *map(str, words)]
    process = subprocess.Popen(
        command, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        yield process
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


@contextmanager
def run_knifetip(database: str, *more: str) -> Iterator[str]:
    """Run a server without worker, machine and limit of requests; yield its URL."""
    port = free_port()
    parts = ["--no-simulator", "--no-compiles", "--no-samples"]
    limits = ["--max-rate", "0", "--max-connections", "4096"]
    with run_process(
        "knifetip.cli", "serve", "--port", port, "--database", database, *parts, *limits, *more
    ):
        yield wait_until_ready(f"http://127.0.0.1:{port}")


def wait_until_ready(url: str, seconds: float = 120.0) -> str:
    """Wait until a server is ready; return its URL."""
    end = time.monotonic() + seconds
    with httpx.Client(base_url=url, trust_env=False) as client:
        while True:
            try:
                if client.get("/readyz").status_code == 200:
                    return url
            except httpx.HTTPError:
                pass
            assert time.monotonic() < end, f"{url} is not ready"
            time.sleep(0.1)


async def post_orders(
    url: str, body: dict[str, Any], count: int, clients: int
) -> tuple[list[float], Counter[int], float]:
    """Send one order many times; return seconds of each, statuses, and orders per second."""
    took: list[float] = []
    statuses: Counter[int] = Counter()
    left = iter(range(count))
    limits = httpx.Limits(max_connections=clients)
    async with httpx.AsyncClient(
        base_url=url, timeout=120.0, trust_env=False, limits=limits
    ) as client:

        async def send() -> None:
            for _ in left:
                began = time.perf_counter()
                statuses[(await client.post("/api/jobs", json=body)).status_code] += 1
                took.append(time.perf_counter() - began)

        began = time.perf_counter()
        await asyncio.gather(*(send() for _ in range(clients)))
        return took, statuses, count / (time.perf_counter() - began)


def percentile(times: Sequence[float], share: float) -> float:
    """Return a percentile in ms."""
    return 1000.0 * sorted(times)[min(int(share * len(times)), len(times) - 1)]
