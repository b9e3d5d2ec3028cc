"""The transition to the safe state: which commands are sent, in which order, and which never."""

from __future__ import annotations

import pytest

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    ControllerRejected,
    ControllerSilent,
)
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.grbl.recovery import make_safe
from knifetip.library import load

SAFE = SafeState((0, 1), 20.0)
RELEASE = ["M5", "M65 P0", "M65 P1"]
LIFT = "$J=G90 G21 Z20.0000 F6000"


class Machine:
    """A controller that behaves like grblHAL, without a connection."""

    name = "machine"

    def __init__(self, state: State = State.RUN, z: float = -0.3, last_alarm: int = 0) -> None:
        self.state = state
        self.z = z
        self.last_alarm = last_alarm
        self.done: list[str] = []
        self.slowing = 2  # number of reports until it is at rest
        self.refuses: set[str] = set()
        self.unreachable = 0
        self.homing_lock = False

    async def reach(self) -> None:
        if self.unreachable:
            self.unreachable -= 1
            raise ControllerError("controller.closed", name="wire")

    async def realtime(self, byte: bytes) -> None:
        self.done.append(byte.decode())
        if self.state is State.RUN:
            self.state = State.HOLD

    async def report(self) -> Status:
        self.slowing = max(self.slowing - 1, 0)
        still = self.state is not State.RUN and not self.slowing
        return Status(self.state, (1.0, 2.0, self.z, 0.0), 0, still)

    async def reset(self) -> None:
        assert not self.slowing, "a reset while it moves loses steps"
        self.done.append("reset")
        if self.state not in (State.ALARM, State.DOOR):
            self.state = State.IDLE

    async def command(self, text: bytes) -> list[str]:
        line = text.decode()
        locked = self.state is State.ALARM and line != "$X"
        if locked or line in self.refuses or (line == "$X" and self.homing_lock):
            raise ControllerRejected(
                "controller.rejected-command", name="it", command=line, error="locked", code=9
            )
        self.done.append(line)
        if line == "$X":
            self.state = State.IDLE
        elif line == LIFT:
            self.z = 20.0
        return []


async def test_it_holds_comes_to_rest_resets_lifts_and_then_releases() -> None:
    machine = Machine()
    status = await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset", LIFT, *RELEASE]
    assert status.position == (1.0, 2.0, 20.0, 0.0)


async def test_a_pressed_emergency_stop_is_reported_at_once() -> None:
    # grblHAL ignores a reset while the button is pressed, so its banner would be awaited in vain.
    machine = Machine(State.ALARM, last_alarm=10)
    with pytest.raises(ControllerAlarm, match="emergency stop"):
        await make_safe(machine, SAFE, 60.0)
    assert machine.done == ["!"]


async def test_nothing_moves_while_the_safety_door_is_open_and_it_is_not_waited_for() -> None:
    machine = Machine(State.DOOR)
    # Closing the door must not start the lift, so a later attempt is a person's.
    with pytest.raises(ControllerOccupied, match="safety door is open"):
        await make_safe(machine, SAFE, 60.0)
    assert machine.done == ["!", "reset"]


async def test_a_tool_that_is_high_enough_is_not_moved() -> None:
    machine = Machine(z=20.0)
    await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset", *RELEASE]


@pytest.mark.parametrize("code", [2, 3])
async def test_after_a_reset_while_moving_or_a_soft_limit_it_is_unlocked(code: int) -> None:
    machine = Machine(State.ALARM, last_alarm=code)
    await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset", "$X", LIFT, *RELEASE]


@pytest.mark.parametrize("code", [-1, 0, 1, 4, 11, 12, 17])
async def test_after_any_other_alarm_nothing_is_unlocked(code: int) -> None:
    machine = Machine(State.ALARM, last_alarm=code)
    with pytest.raises(ControllerAlarm, match="stations may still be lowered") as alarm:
        await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset"]
    assert "raise the stations at the table" in alarm.value.hint


async def test_a_machine_that_must_be_homed_first_stays_locked() -> None:
    machine = Machine(State.ALARM, last_alarm=3)
    machine.homing_lock = True
    with pytest.raises(ControllerAlarm, match="locked by ALARM:3"):
        await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset"]


async def test_what_is_refused_is_named_and_everything_else_is_done() -> None:
    machine = Machine()
    machine.refuses = {LIFT, "M65 P0"}
    with pytest.raises(
        ControllerRejected, match=r"rejected the command \$J.* rejected the command M65 P0"
    ):
        await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset", "M5", "M65 P1"]


async def test_an_unreachable_controller_is_tried_again_and_given_up() -> None:
    machine = Machine()
    machine.unreachable = 1
    await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset", LIFT, *RELEASE]
    machine = Machine()
    machine.unreachable = 10**6
    with pytest.raises(ControllerError, match="closed"):
        await make_safe(machine, SAFE, 0.02)
    assert machine.done == []


async def test_a_controller_that_reports_nothing_is_reset_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    machine = Machine()
    machine.slowing = 0
    real = machine.report

    async def report() -> Status:
        if "reset" not in machine.done:
            raise ControllerSilent("controller.closed", name="wire")
        return await real()

    monkeypatch.setattr(machine, "report", report)
    await make_safe(machine, SAFE, 0.2)
    assert machine.done == ["!", "reset", LIFT, *RELEASE]


def test_the_safe_state_of_a_machine_has_all_its_outputs_off_and_z_at_travel_height() -> None:
    machine = load.machine("demo-table")
    assert SafeState.from_machine(machine) == SafeState((0, 1, 2), 20.0)
