"""A job does not start with a tool at the end of its life without a decision of the operator."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip.contract.job import Actor, ActorKind
from knifetip.errors import NotFound, WrongState
from knifetip.library import load
from knifetip.model.machine import Machine
from knifetip.service.database.tables import Job
from knifetip.service.gateways.heartbeats import GatewayReport
from knifetip.service.store import Store
from knifetip.service.tools.check import ToolCheck
from tests.support.job_states import (
    LINES,
    RESULT,
    WAITING,
    compiling,
    confirm,
)
from tests.support.stored import Clock
from tests.unit.service.history.test_runs import table

NAME = "demo-table"
MIA = Actor(ActorKind.OPERATOR, "Mia")
#: A copy works 400 mm with the knife.
WITH_TOOL = replace(
    RESULT,
    lengths=table(),
    tools=[{"station": 1, "name": "Oscillating knife", "kind": "knife"}],
)


@pytest.fixture(scope="module")
def machine() -> Machine:
    return load.machine(NAME, files=False)


def waiting(store: Store, copies: int = 1, *, feeds: bool = False) -> Job:
    """Return a claimed job with a tool in station 1 that waits for its confirmation."""
    job = compiling(store, machine=NAME, copies=copies, release=True)
    store.compiles.save_result(job.id, job.epoch, WITH_TOOL)
    claimed = store.gateways.claim(NAME, "gateway", manual=not feeds, feeds=feeds)
    assert claimed is not None
    assert claimed.confirmation == "awaited"
    return claimed


def wear(store: Store, machine: Machine) -> None:
    """Give the tool of station 1 a life that is used up."""
    job = waiting(store)
    confirm(store, job.id)
    store.gateways.heartbeat(job.id, job.epoch, WAITING)
    store.gateways.finish(job.id, job.epoch, "done")
    store.tools.set_life(machine, 1, 400.0, MIA)
    assert store.tools.uses(machine)[0].warning == "over"


def codes(store: Store, id: str) -> list[str]:
    return [event.message.code for event in store.events.of_job(id) if event.message is not None]


def test_a_worn_tool_refuses_the_confirmation(store: Store, machine: Machine) -> None:
    wear(store, machine)
    job = waiting(store)
    for stated in (ToolCheck(), ToolCheck(changed=[2])):
        with pytest.raises(WrongState) as refused:
            confirm(store, job.id, tools=stated)
        assert refused.value.message.code == "job.worn-tools"
        assert "Oscillating knife" in str(refused.value)
    assert store.jobs.get(job.id).confirmation == "awaited"
    # A refused confirmation records nothing.
    assert store.tools.uses(machine)[1].changed == 0.0
    assert store.gateways.heartbeat(job.id, job.epoch, WAITING) == "wait"


def test_a_new_tool_is_recorded_with_the_confirmation(
    store: Store, machine: Machine, clock: Clock
) -> None:
    wear(store, machine)
    clock.now += 1.0
    job = waiting(store)
    confirmed = confirm(store, job.id, by="Kim", tools=ToolCheck(changed=[1]))
    assert confirmed.confirmation == "given"
    use = store.tools.uses(machine)[0]
    assert (use.used, use.changed, use.changed_by) == (0.0, clock.now, "operator Kim")
    # A repeated confirmation changes nothing.
    confirm(store, job.id, by="Kim", tools=ToolCheck(changed=[1]))
    assert len([one for one in store.tools.events(NAME) if one.kind == "changed"]) == 1
    assert codes(store, job.id)[-2:] == ["job.tool-changed", "job.confirmed-table"]


def test_a_reason_to_use_a_tool_on_is_recorded(store: Store, machine: Machine) -> None:
    wear(store, machine)
    job = waiting(store)
    confirm(store, job.id, by="Kim", tools=ToolCheck(reason="last sheet of the day"))
    *_, kept, _ = store.events.of_job(job.id)
    assert kept.message is not None
    assert kept.message.arguments["reason"] == "last sheet of the day"
    assert kept.who == "operator Kim"
    assert codes(store, job.id)[-2:] == ["job.worn-tools-used", "job.confirmed-table"]
    assert store.tools.uses(machine)[0].warning == "over"


def test_a_tool_of_another_station_does_not_matter(store: Store, machine: Machine) -> None:
    wear(store, machine)
    store.tools.set_life(machine, 1, 0.0, MIA)
    store.tools.set_life(machine, 3, 1e-6, MIA)
    job = waiting(store)
    assert confirm(store, job.id).confirmation == "given"


def test_an_unknown_station_cannot_have_a_new_tool(store: Store, machine: Machine) -> None:
    job = waiting(store)
    with pytest.raises(NotFound, match="has no station 9"):
        confirm(store, job.id, tools=ToolCheck(changed=[9]))
    assert store.jobs.get(job.id).confirmation == "awaited"
    assert machine.name == NAME


def between_copies(store: Store, machine: Machine, *, feeds: bool) -> tuple[Job, GatewayReport]:
    """Return a job whose first copy has used up the life of its tool, and its last report."""
    store.tools.set_life(machine, 1, 400.0, MIA)
    job = waiting(store, copies=3, feeds=feeds)
    confirm(store, job.id)
    store.gateways.heartbeat(job.id, job.epoch, WAITING)
    report = GatewayReport(line=LINES, copies_done=1, held=True)
    store.gateways.heartbeat(job.id, job.epoch, report, lambda _: {1})
    assert store.jobs.get(job.id).confirmation == "sheet"
    return job, report


@pytest.mark.parametrize("feeds", [False, True])
def test_between_two_copies_resume_does_not_pass_by_the_check(
    store: Store, machine: Machine, feeds: bool
) -> None:
    job, report = between_copies(store, machine, feeds=feeds)
    with pytest.raises(WrongState, match="waits for a new sheet"):
        store.operators.resume(job.id, hands_clear=True)
    with pytest.raises(WrongState) as refused:
        confirm(store, job.id)
    assert refused.value.message.code == "job.worn-tools"
    assert store.gateways.heartbeat(job.id, job.epoch, report, lambda _: {1}) != "resume"
    confirm(store, job.id, tools=ToolCheck(changed=[1]))
    assert store.gateways.heartbeat(job.id, job.epoch, report, lambda _: {1}) == "resume"


def test_a_tool_changed_within_a_run_begins_with_0(
    store: Store, machine: Machine, clock: Clock
) -> None:
    job, _ = between_copies(store, machine, feeds=False)
    clock.now += 1.0
    confirm(store, job.id, tools=ToolCheck(changed=[1]))
    assert store.tools.uses(machine)[0].used == 0.0
    second = GatewayReport(line=20, copies_done=1)
    store.gateways.heartbeat(job.id, job.epoch, second)
    assert store.tools.uses(machine)[0].used == pytest.approx(300.0)
    clock.now += 1.0
    store.gateways.finish(job.id, job.epoch, "cancelled", line=30, copies_done=1)
    assert store.tools.uses(machine)[0].used == pytest.approx(400.0)
