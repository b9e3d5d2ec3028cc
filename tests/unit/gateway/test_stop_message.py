"""The message about an interrupted program whose machine did not reach its safe state."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from knifetip.errors import ControllerAlarm, ControllerError
from knifetip.gateway import stream
from knifetip.gateway.controller import State, Status
from knifetip.gateway.grbl.answers import alarm_meaning
from knifetip.messages import Message, render

BASE = Status(State.IDLE, (0.0, 0.0, 20.0, 0.0), 0, True)


def alarm(code: int) -> ControllerAlarm:
    meaning = alarm_meaning(code)
    return ControllerAlarm("controller.alarm", name="grbl", code=code, alarm=meaning, due=None)


def locked(code: int) -> ControllerAlarm:
    cause = Message("controller.alarm-code", code=code, alarm=alarm_meaning(code))
    return ControllerAlarm("controller.locked", name="grbl", cause=cause)


async def stop_error(error: ControllerError, unsafe: ControllerError) -> ControllerError:
    async def stop() -> Status:
        raise unsafe

    controller: Any = SimpleNamespace(observer=None, sent=5, stop=stop)
    follower: Any = SimpleNamespace(lines=3)
    return await stream._stop(controller, error, follower, BASE, 40)


@pytest.mark.parametrize("unsafe", [locked(1), alarm(1)])
async def test_an_alarm_is_stated_once(unsafe: ControllerAlarm) -> None:
    found = await stop_error(alarm(1), unsafe)
    assert isinstance(found, ControllerAlarm)
    assert found.text.count(render(alarm_meaning(1))) == 1
    assert "not in a safe state: the stations may still be lowered" in found.text
    assert "raise the stations" in found.hint
    assert "home the machine" in found.hint


async def test_another_alarm_is_stated_too() -> None:
    found = await stop_error(alarm(1), locked(3))
    assert render(alarm_meaning(1)) in found.text
    assert render(alarm_meaning(3)) in found.text
