"""The clock that the processes of one database share."""

from __future__ import annotations

import threading
import time

import pytest
import sqlalchemy as sa

from knifetip.gateway.journal import default_path
from knifetip.service.database.shared_clock import SharedClock
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.lifecycle.transitions import LEASE
from tests.support.job_states import running
from tests.support.stored import migrated_store


class _Server:
    """A server whose clock and connection a test sets."""

    def __init__(self) -> None:
        self.uptime = 50.0
        self.ahead = 1000.0
        self.readings = 0
        self.reachable = True

    def read(self) -> float:
        self.readings += 1
        if not self.reachable:
            raise sa.exc.OperationalError("SELECT", None, Exception("no connection"))
        return self.uptime + self.ahead


def test_the_server_is_read_only_every_ten_seconds() -> None:
    server = _Server()
    clock = SharedClock(server.read, lambda: server.uptime)
    for _ in range(100):
        assert clock() == pytest.approx(server.uptime + 1000.0)
        server.uptime += 0.1
    assert server.readings == 1
    server.ahead = 2000.0
    server.uptime += 10.0
    assert clock() == pytest.approx(server.uptime + 2000.0)
    assert server.readings == 2


def test_the_clock_goes_on_while_the_server_cannot_be_read() -> None:
    server = _Server()
    clock = SharedClock(server.read, lambda: server.uptime)
    began = clock()
    server.reachable = False
    server.uptime += 60.0
    assert clock() == pytest.approx(began + 60.0)
    clock()
    assert server.readings == 2
    with pytest.raises(sa.exc.OperationalError):
        SharedClock(server.read, lambda: server.uptime)()


def test_threads_do_not_wait_for_one_that_reads_the_server() -> None:
    # That one may wait for a connection that one of the others has.
    server = _Server()
    asked, answered = threading.Event(), threading.Event()

    def read() -> float:
        if server.readings:
            asked.set()
            assert answered.wait(60.0)
        return server.read()

    clock = SharedClock(read, lambda: server.uptime)
    began = clock()
    server.uptime += 60.0
    reading = threading.Thread(target=clock)
    reading.start()
    assert asked.wait(60.0)
    times: list[float] = []
    other = threading.Thread(target=lambda: times.append(clock()))
    other.start()
    other.join(10.0)
    before = list(times)
    answered.set()
    for thread in (reading, other):
        thread.join(60.0)
    assert before == [pytest.approx(began + 60.0)]
    assert server.readings == 2


def test_a_computer_whose_clock_is_ahead_takes_no_job_from_a_gateway(
    migrated_postgresql: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    true_time = time.time
    with (
        migrated_store(migrated_postgresql, None) as office,
        migrated_store(migrated_postgresql, None) as workshop,
    ):
        job = running(office)
        monkeypatch.setattr(time, "time", lambda: true_time() + 10.0 * LEASE)
        assert abs(workshop.database.clock() - true_time()) < 1.0
        assert workshop.leases.run()
        assert workshop.jobs.get(job.id).state == "running"
        workshop.gateways.heartbeat(job.id, job.epoch, GatewayReport(line=7))
        monkeypatch.setattr(time, "time", true_time)
        assert office.leases.run()
        assert office.jobs.get(job.id).lease < true_time() + LEASE + 1.0


def test_each_machine_and_server_has_a_journal_of_its_own(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", "/state")
    paths = [
        default_path(machine, server)
        for machine in ("demo-table", "router-table")
        for server in ("http://office:8080", "http://office:8081")
    ]
    assert len(set(paths)) == 4
    assert str(paths[0]) == "/state/knifetip/demo-table-http-office-8080.gateway.jsonl"
