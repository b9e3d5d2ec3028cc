"""One trace follows an order through server, worker and gateway, each a process of its own."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest
import sqlalchemy as sa

from tests.support.serving.server import (
    confirm_job,
    order_job,
    process_environment,
    square,
    upload_drawing,
    wait_for_state,
)
from tests.support.serving.trace_receiver import (
    ReceivedSpan,
    TraceReceiver,
    run_silent_receiver,
    run_trace_receiver,
)

TRACE = "4bf92f3577b34da6a3ce929d0e0e4736"
CALLER = "00f067aa0ba902b7"
KEY = "SECRET-key-of-the-server"


class Process:
    """A command of knifetip in a process of its own, with its stderr in a file."""

    def __init__(self, folder: Path, environment: Mapping[str, str], *words: object) -> None:
        self._log = folder / f"{words[0]}.log"
        with self._log.open("w") as log:
            self.popen = subprocess.Popen(
                [sys.executable, "-m", "knifetip.cli", *map(str, words)],
                stdout=subprocess.DEVNULL,
                stderr=log,
                env={**process_environment(), **environment},
            )

    @property
    def log(self) -> str:
        return self._log.read_text()

    def wait_for(self, text: str) -> str:
        """Wait for a text in the log; return the rest of its line."""
        end = time.monotonic() + 60.0
        while time.monotonic() < end:
            assert self.popen.poll() is None, self.log
            for line in self.log.splitlines():
                if text in line:
                    return line.partition(text)[2].strip()
            time.sleep(0.02)
        raise AssertionError(self.log)

    def end(self) -> int:
        """End the process like Ctrl-C; return its exit code."""
        if self.popen.poll() is None:
            self.popen.send_signal(signal.SIGINT)
        return self.popen.wait(30.0)


@contextmanager
def process(folder: Path, environment: Mapping[str, str], *words: object) -> Iterator[Process]:
    running = Process(folder, environment, *words)
    try:
        yield running
    finally:
        running.end()


@pytest.fixture
def postgresql_or_sqlite(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """URL of a new database: in PostgreSQL if it is installed; compiles are workflows there."""
    try:
        url: str = request.getfixturevalue("postgresql_url")
    except pytest.skip.Exception:
        return f"sqlite:///{tmp_path}/shop.sqlite"
    return url


def test_one_trace_follows_an_order_through_three_processes(
    postgresql_or_sqlite: str, tmp_path: Path
) -> None:
    database = ("--database", postgresql_or_sqlite)
    with ExitStack() as running, run_trace_receiver() as traces:
        started: list[Process] = []

        def start(*words: object, key: str = KEY) -> Process:
            environment = {**traces.environment, "KNIFETIP_KEY": key}
            started.append(running.enter_context(process(tmp_path, environment, *words)))
            return started[-1]

        table = start("simulator", "--port", 0, "--speed", 10_000)
        server = start(
            *("serve", "--port", 0, *database, "--no-samples", "--no-simulator", "--no-compiles")
        )
        url = server.wait_for("knifetip is at ")
        start("worker", *database, "--name", "worker")
        controller = table.wait_for("listening on ")
        client = running.enter_context(
            httpx.Client(
                base_url=url,
                headers={"Authorization": f"Bearer {KEY}"},
                timeout=60.0,
                trust_env=False,
            )
        )
        new_key = {"title": "SECRET table", "scopes": ["gateway"]}
        start(
            *("gateway", "--server", url, "--controller", controller),
            *("--journal", tmp_path / "journal"),
            key=client.post("/api/keys", json=new_key).raise_for_status().json()["secret"],
        )
        drawing = upload_drawing(client, square())
        client.headers["traceparent"] = f"00-{TRACE}-{CALLER}-01"
        job = order_job(client, drawing["id"], customer="SECRET Ltd", release=True, copies=2)
        del client.headers["traceparent"]
        done(client, job["id"])
        run = traces.wait_for("run")
        finish = traces.wait_for("POST /api/gateway/finish")
        for one in started:
            one.popen.kill()
    assert_chain(traces, job, run, finish)
    assert not any(b"SECRET" in body for body in traces.bodies)
    engine = sa.create_engine(postgresql_or_sqlite)
    with engine.connect() as connection:
        stored = connection.execute(sa.text("SELECT traceparent FROM job")).scalar()
    engine.dispose()
    (order,) = (one for one in traces.named("POST /api/jobs") if one.trace_id == TRACE)
    assert stored == f"00-{TRACE}-{order.span_id}-01"


def done(client: httpx.Client, job: str) -> None:
    """Wait until a job is done; confirm each sheet as an operator does."""
    end = time.monotonic() + 60.0
    while (status := client.get(f"/api/jobs/{job}").json())["state"] != "done":
        assert time.monotonic() < end, status
        assert status["state"] not in ("refused", "interrupted"), status
        if status["waiting_for"] in ("confirmation", "sheet"):
            confirm_job(client, job)
        time.sleep(0.05)


def assert_chain(
    traces: TraceReceiver, job: dict[str, Any], run: ReceivedSpan, finish: ReceivedSpan
) -> None:
    """Check the parents and the processes of all spans of an order."""
    spans = {one.span_id: one for one in traces.spans}

    def line(span: ReceivedSpan) -> list[str]:
        """Return a span and those to which it belongs, as process and name, up to the caller."""
        found = [f"{span.service['service.name'].removeprefix('knifetip-')}: {span.name}"]
        assert span.trace_id == TRACE
        if span.parent_id == CALLER:
            return found
        return found + line(spans[span.parent_id])

    order = ["server: POST /api/jobs"]
    compiled = traces.wait_for("compile")
    assert line(compiled) == ["worker: compile", *order]
    for stage in ("read", "clean", "plan", "compensate", "sequence", "process", "verify"):
        (one,) = (one for one in traces.named(stage) if one.parent_id == compiled.span_id)
        assert line(one) == [f"worker: {stage}", "worker: compile", *order]
    assert line(run) == ["gateway: run", *order]
    assert run.attributes == {
        "knifetip.job": job["id"],
        "knifetip.machine": "demo-table",
        "knifetip.copies": 2,
        "knifetip.outcome": "done",
    }
    assert [name for name in traces.children(run) if name != finish.name] == [
        *("wait for confirmation", "fetch program", "copy", "wait for sheet", "copy"),
    ]
    first, second = traces.named("copy")
    lines = compiled.attributes["knifetip.lines"]
    for number, copy in enumerate((first, second), 1):
        assert copy.attributes["knifetip.copy"] == number
        assert copy.attributes["knifetip.lines"] == copy.attributes["knifetip.line"] == lines
        events = [attributes["knifetip.line"] for _, attributes in copy.events]
        assert events == sorted(events)
        assert events[-1] == lines
    assert line(finish) == ["server: POST /api/gateway/finish", "gateway: run", *order]
    (program,) = traces.named("GET /api/gateway/program/{id}")
    assert line(program) == [
        *("server: GET /api/gateway/program/{id}", "gateway: fetch program", "gateway: run"),
        *order,
    ]
    instances = {one.service["service.instance.id"] for one in traces.spans}
    assert len(instances) == 3


@pytest.mark.long
def test_an_order_is_done_although_the_receiver_of_traces_is_silent(tmp_path: Path) -> None:
    database = f"sqlite:///{tmp_path}/shop.sqlite"
    words = ("serve", "--port", 0, "--database", database, "--no-samples", "--speed", 10_000)
    with run_silent_receiver() as silent, process(tmp_path, silent.environment, *words) as server:
        url = server.wait_for("knifetip is at ")
        with httpx.Client(base_url=url, timeout=60.0, trust_env=False) as client:
            drawing = upload_drawing(client, square())
            assert silent.asked.wait(30.0)  # from now on an export is under way, without an end
            job = order_job(client, drawing["id"], release=True)
            wait_for_state(client, job["id"], "done", confirm=True)
        # An export lasts 600 s; the end of the server waits 2 s for it.
        assert server.end() == 0
        assert server.log.count("the receiver does not answer") == 1
