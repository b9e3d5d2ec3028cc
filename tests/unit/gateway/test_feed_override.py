"""The feed override of grbl: realtime commands, of which a controller may forget some."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest

from knifetip.errors import ControllerError
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl import answers, driver, operating
from knifetip.gateway.grbl.driver import Grbl
from knifetip.library import load
from knifetip.simulators.grbl.simulator import Server
from knifetip.simulators.grbl.table import Table

MACHINE = load.machine("demo-table")


class Recorder(Table):
    """A table that records the changes of its feed override, and may ignore them."""

    deaf = False

    def __init__(self) -> None:
        super().__init__(MACHINE)
        self.commands: list[int] = []

    def _change_override(self, command: int) -> None:
        self.commands.append(command)
        if not self.deaf:
            super()._change_override(command)


@asynccontextmanager
async def dialled() -> AsyncIterator[tuple[Recorder, Grbl]]:
    server = Server(Recorder())
    await server.start("127.0.0.1", 0)
    async with server:
        safe = SafeState.from_machine(MACHINE)
        controller = await driver.dial(server.address, safe, silence=1.0, poll=0.02)
        table = server.table
        assert isinstance(table, Recorder)
        table.commands.clear()
        try:
            yield table, controller
        finally:
            await controller.close()


@pytest.mark.parametrize(
    ("percent", "commands"),
    [
        (110, [0x91]),
        (70, [0x92] * 3),
        (97, [0x94] * 3),
        (123, [0x91] * 2 + [0x93] * 3),
        (200, [0x91] * 10),
        (10, [0x92] * 9),
    ],
)
async def test_it_is_reached_in_steps(percent: int, commands: list[int]) -> None:
    async with dialled() as (table, controller):
        await controller.override_feed(percent)
        assert table.commands == commands
        assert table.override == percent
        assert (await controller.status()).override == percent
        table.commands.clear()
        await controller.override_feed(100)
        assert table.commands == [0x90]
        assert table.override == 100


async def test_a_controller_that_does_not_change_it_is_an_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(operating, "_OVERRIDE_PAUSE", 0.0)
    monkeypatch.setattr(operating, "_OVERRIDE_REPORTS", 2)
    async with dialled() as (table, controller):
        table.deaf = True
        with pytest.raises(ControllerError, match=r"override of 100 % instead of 90 %"):
            await controller.override_feed(90)


@pytest.mark.parametrize(
    ("line", "override"),
    [("<Run|MPos:0,0,0|FS:0,0|Ov:73,100,100>", 73), ("<Run|MPos:0,0,0|FS:0,0>", None)],
)
def test_it_is_read_from_reports(line: str, override: int | None) -> None:
    report = answers.report(line)
    assert report is not None
    assert report.override == override
