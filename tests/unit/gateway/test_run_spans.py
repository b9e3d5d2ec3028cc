"""The run of a job is a span of the trace of its order, with its waits, its copies and its end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from knifetip.simulators.grbl.table import Faults
from tests.support.serving.trace_receiver import TraceReceiver, export_traces
from tests.unit.gateway.test_claim import PROGRAM, Beat, Office, gateway, table

TRACE, ORDER = "4bf92f3577b34da6a3ce929d0e0e4736", "00f067aa0ba902b7"
LINES = PROGRAM.count(b"\n")


@pytest.fixture
def traces() -> Iterator[TraceReceiver]:
    with export_traces() as receiver:
        yield receiver


def office(**options: Any) -> Office:
    """Return a fake server whose job has the trace of an order."""
    fake = Office(**options)
    fake.claim["traceparent"] = f"00-{TRACE}-{ORDER}-01"
    return fake


async def test_a_run_belongs_to_the_order_and_its_reports_to_the_run(traces: TraceReceiver) -> None:
    server = office()
    async with table() as machine:
        await gateway(server, machine)
    run = traces.wait_for("run")
    assert (run.trace_id, run.parent_id, run.kind) == (TRACE, ORDER, "consumer")
    assert run.attributes["knifetip.outcome"] == "done"
    assert not run.failed
    assert traces.children(run) == ["fetch program", "copy"]
    (copy,) = traces.named("copy")
    assert copy.attributes == {
        "knifetip.copy": 1,
        "knifetip.line": LINES,
        "knifetip.lines": LINES,
    }
    assert copy.events[-1] == ("lines executed", {"knifetip.line": LINES})
    # Of the requests, those that are no repetition have the context: program and end.
    sent = [headers["traceparent"] for headers in server.headers if "traceparent" in headers]
    (fetch,) = traces.named("fetch program")
    assert [context[3:52] for context in sent] == [
        f"{TRACE}-{fetch.span_id}",
        f"{TRACE}-{run.span_id}",
    ]


async def test_a_hold_is_an_event_of_its_copy(traces: TraceReceiver) -> None:
    server = office()
    held = 0

    def command(beat: Beat) -> str:
        nonlocal held
        if beat["held"]:
            held += 1
            return "resume" if held > 5 else "continue"
        return "hold" if beat["line"] == 6 and not held else "continue"

    server.command = command
    async with table(speed=2.0) as machine:
        await gateway(server, machine)
    events = [event for event in traces.wait_for("copy").events if event[0] != "lines executed"]
    assert events == [("held", {"knifetip.line": 6}), ("resumed", {"knifetip.line": 6})]


async def test_an_interruption_has_its_code_and_line_but_no_text(traces: TraceReceiver) -> None:
    server = office()
    async with table(faults=Faults(disconnect=11)) as machine:
        await gateway(server, machine)
    run, copy = traces.wait_for("run"), traces.wait_for("copy")
    assert run.failed
    assert copy.failed
    assert run.attributes["knifetip.outcome"] == "interrupted"
    assert run.attributes["error.type"] == server.finished[0]["why"]["code"]
    assert copy.attributes["error.type"] == run.attributes["error.type"]
    assert copy.attributes["knifetip.line"] < LINES
    assert not any(b"is lost" in body for body in traces.bodies)


async def test_a_run_without_a_context_begins_a_trace(traces: TraceReceiver) -> None:
    async with table() as machine:
        await gateway(Office(), machine)
    assert traces.wait_for("run").parent_id == ""
