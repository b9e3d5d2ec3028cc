"""States of a controller without a job: what the page says, and the way out of each."""

from __future__ import annotations

import pytest

from knifetip.gateway.controller import State, Status
from knifetip.gateway.grbl import answers
from knifetip.gateway.obstacle import RELEASABLE, obstacle_of
from knifetip.messages import hint

AT = "|MPos:0.000,0.000,20.000,0.000"


def status_of(report: str) -> Status:
    found = answers.report(report)
    assert found is not None
    assert found.machine is not None
    return Status(
        found.state,
        found.machine,
        0,
        found.still,
        pressed=found.pressed,
        door_open=found.door_open,
    )


@pytest.mark.parametrize(
    ("report", "code", "released"),
    [
        (f"<Idle{AT}>", None, False),
        (f"<Idle{AT}|Pn:P>", None, False),
        (f"<Idle{AT}|Pn:XZ>", "obstacle.limit-pressed", False),
        (f"<Hold:0{AT}>", "obstacle.held", True),
        (f"<Hold:1{AT}>", "obstacle.held", True),
        (f"<Door:0{AT}>", "obstacle.door-closed", True),
        (f"<Door:1{AT}|Pn:D>", "obstacle.door-open", False),
        (f"<Door:2{AT}|Pn:D>", "obstacle.door-open", False),
        (f"<Door:3{AT}>", "obstacle.door-open", False),
        (f"<Check{AT}>", "obstacle.check-mode", True),
        (f"<Sleep{AT}>", "obstacle.asleep", True),
        (f"<Tool{AT}>", "obstacle.tool-change", True),
        (f"<Run{AT}>", "obstacle.moves", True),
        (f"<Unknown{AT}>", "obstacle.busy", True),
        (f"<Jog{AT}>", None, False),  # ends by itself, or with Stop
        (f"<Home{AT}>", None, False),
        *((f"<Alarm:{number}{AT}>", None, False) for number in range(1, 12)),  # unlock or home
    ],
)
def test_every_state_names_what_is_in_the_way_and_what_to_do(
    report: str, code: str | None, *, released: bool
) -> None:
    status = status_of(report)
    obstacle = obstacle_of(status, "grbl")
    assert (None if obstacle is None else obstacle.code) == code
    assert obstacle is None or hint(obstacle)
    assert (status.state in RELEASABLE and not status.door_open) is released


def test_a_pressed_limit_switch_names_its_axes() -> None:
    message = obstacle_of(status_of(f"<Idle{AT}|Pn:XZ>"), "grbl")
    assert str(message) == "A limit switch of grbl is still pressed (X, Z)."


def test_every_state_without_a_job_leads_somewhere() -> None:
    moving = {State.JOG, State.HOME}
    assert set(State) == RELEASABLE | moving | {State.IDLE, State.ALARM}
