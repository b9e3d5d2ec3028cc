"""The settings of a controller are compared with what the programs of its machine presuppose."""

from __future__ import annotations

from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from dataclasses import replace

import pytest

from knifetip.errors import ControllerError
from knifetip.gateway.controller import SafeState
from knifetip.gateway.grbl import settings
from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.gateway.grbl.driver import Grbl, dial
from knifetip.gateway.linuxcnc import ini_settings
from knifetip.gateway.machine_link import MachineLink
from knifetip.gateway.presupposed import compare
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.simulators.grbl.firmware import Firmware
from knifetip.simulators.grbl.simulator import Server
from knifetip.simulators.grbl.table import Table
from tests.unit.gateway.test_grbl import Wire, opened

KNIFE = load.machine("demo-table")
LASER = load.machine("laser-table")
ROUTER = load.machine("router-table")
SAFE = SafeState.from_machine(KNIFE)


@asynccontextmanager
async def table(machine: Machine, changed: Mapping[int, str], axes: str) -> AsyncIterator[Server]:
    """Serve a simulated table with changed settings."""
    server = Server(Table(machine, firmware=Firmware(axes)))
    server.table.settings |= changed
    await server.start("127.0.0.1", 0)
    try:
        yield server
    finally:
        await server.close()


async def connected(server: Server, machine: Machine = KNIFE) -> Grbl:
    return await dial(server.address, SafeState.from_machine(machine), silence=1.0, poll=0.02)


def summary(messages: tuple[Message, ...]) -> list[tuple[str, str, str, str]]:
    """Return setting, found value, expected value and reason of each difference."""
    return [
        (
            one.arguments["setting"],
            one.arguments["found"],
            one.arguments["expected"],
            one.arguments["reason"].code.removeprefix("setting."),
        )
        for one in messages
    ]


@pytest.mark.parametrize("axes", ["XYZC", "XYZA", "XYZABC"])
@pytest.mark.parametrize("machine", [KNIFE, LASER])
async def test_a_controller_that_agrees_with_the_machine_file_has_no_notices(
    machine: Machine, axes: str
) -> None:
    async with table(machine, {}, axes) as server:
        controller = await connected(server, machine)
        assert controller.notices == ()
        await controller.close()


@pytest.mark.parametrize(
    ("machine", "changed", "found"),
    [
        (KNIFE, {13: "1"}, ("$13", "1", "0", "inches")),
        (KNIFE, {32: "1"}, ("$32", "1", "0", "laser-mode-stops-spindle")),
        (LASER, {32: "0"}, ("$32", "0", "1", "no-laser-mode")),
        (KNIFE, {23: "4"}, ("$23", "4", "0", "z-homes-down")),
        (KNIFE, {10: "3"}, ("$10", "3", "511", "no-work-offset")),
        (KNIFE, {101: "0.000"}, ("$101", "0.000", "STEPS", "no-steps")),
        (KNIFE, {112: "0.000"}, ("$112", "0.000", "30000", "no-rate")),
        (KNIFE, {123: "0.000"}, ("$123", "0.000", "36000", "no-rate")),
    ],
)
async def test_a_dangerous_setting_is_refused_before_anything_moves(
    machine: Machine, changed: dict[int, str], found: tuple[str, str, str, str]
) -> None:
    async with table(machine, changed, "XYZC") as server:
        server.table.outputs[1] = True
        with pytest.raises(ControllerError, match="would be dangerous") as refused:
            await connected(server, machine)
        assert summary(refused.value.message.arguments["differences"]) == [found]
        setting, _, expected, _ = found
        assert f"{setting}={expected}" in refused.value.hint
        assert server.table.outputs == {1: True}


@pytest.mark.parametrize(
    ("changed", "found"),
    [
        ({10: "508"}, ("$10", "508", "511", "no-buffer-state")),
        ({20: "0"}, ("$20", "0", "1", "no-soft-limits")),
        ({21: "0"}, ("$21", "0", "1", "no-hard-limits")),
        ({22: "0"}, ("$22", "0", "1", "no-homing")),
        ({22: "9"}, ("$23", "0", "3", "homes-at-other-end")),
        ({30: "1"}, ("$30", "1", "1000", "spindle-limit")),
        # 1500 mm/s are 90000 mm/min; 3600 degrees/s are 216000 degrees/min.
        ({110: "45000.000"}, ("$110", "45000.000", "90000", "slower")),
        ({113: "200000.000"}, ("$113", "200000.000", "216000", "slower")),
        ({111: "120000.000"}, ("$111", "120000.000", "90000", "faster")),
        ({120: "10.000"}, ("$120", "10.000", "8000", "slower")),
        # The machine file has X from -100 to 1700.
        ({130: "1600.000"}, ("$130", "1600.000", "1800", "short-travel")),
        # The fourth axis is the first rotary one.
        ({376: "0"}, ("$376", "0", "1", "rotary-axes")),
    ],
)
async def test_a_harmless_setting_is_a_notice(
    changed: dict[int, str], found: tuple[str, str, str, str]
) -> None:
    machine = KNIFE
    if 30 in changed:
        knife = replace(KNIFE.stations[0], spindle_speed=1000.0)
        machine = replace(KNIFE, stations=(knife, *KNIFE.stations[1:]))
    async with table(machine, changed, "XYZC") as server:
        controller = await connected(server, machine)
        assert summary(controller.notices) == [found]
        await controller.close()


async def test_the_rotary_axis_is_that_of_the_letter_of_the_controller() -> None:
    # XYZABC: C is the third rotary axis, bit 2; A and B do not exist in the machine file.
    async with table(KNIFE, {376: "3", 115: "1.000"}, "XYZABC") as server:
        controller = await connected(server)
        assert summary(controller.notices) == [
            ("$376", "3", "7", "rotary-axes"),
            ("$115", "1.000", "216000", "slower"),
        ]
        await controller.close()


async def test_a_travel_of_zero_is_no_limit() -> None:
    async with table(KNIFE, {133: "0.000"}, "XYZC") as server:
        controller = await connected(server)
        assert controller.notices == ()
        await controller.close()


async def test_a_setting_that_was_changed_meanwhile_is_found_before_the_next_program() -> None:
    async with table(KNIFE, {}, "XYZC") as server:
        controller = await connected(server)
        server.table.settings[13] = "1"
        with pytest.raises(ControllerError, match=r"\$13 is 1, expected 0"):
            await controller.check([b"G21"])
        await controller.close()


def refusal_of(link: MachineLink) -> str:
    """Return the code of the reason why a link is not connected; "" for none."""
    return "" if link.refusal is None else link.refusal.code


async def test_a_refused_machine_is_taken_when_its_setting_is_right() -> None:
    async with table(KNIFE, {13: "1"}, "XYZC") as server:
        link = MachineLink(SAFE, lambda safe, stop: dial(server.address, safe, stop_motion=stop))
        with pytest.raises(ControllerError):
            await link.connected()
        assert refusal_of(link) == "controller.settings-refused"
        server.table.settings[13] = "0"
        await link.connected()
        assert refusal_of(link) == ""
        server.table.settings[20] = "0"
        await link.verify_settings()
        controller = link.controller
        assert isinstance(controller, Grbl)
        assert summary(controller.notices) == [("$20", "0", "1", "no-soft-limits")]
        server.table.settings[13] = "1"
        with pytest.raises(ControllerError):
            await link.verify_settings()
        with pytest.raises(ControllerError, match=r"\$13"):
            await link.connected()
        await link.close()


async def test_a_beam_needs_a_controller_that_reports_its_mode() -> None:
    wire = Wire({"$$": "$10=511\n$30=1000\nok"})
    with pytest.raises(ControllerError, match="not in laser mode"):
        async with opened(wire, safe=SafeState.from_machine(LASER)):
            pass
    assert "M5" not in wire.lines


def test_the_lines_to_type_make_a_controller_agree_with_its_machine() -> None:
    lines = settings.setting_lines(KNIFE)
    assert {"$10=511", "$13=0", "$32=0", "$110=90000", "$120=8000", "$130=1800"} < set(lines)
    assert "$376=1" in lines
    found = settings.read(lines)
    required = settings.requirements(KNIFE, Capabilities("XYZC", grblhal=True), found)
    assert compare("grbl", required, found) == ()


INI = """
[TRAJ]
COORDINATES = X Y Z C
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
[KINS]
KINEMATICS = trivkins coordinates=XYZC
"""


def ini(machine: Machine) -> dict[str, str]:
    """Return the entries of an INI file that agrees with a machine."""
    return ini_settings.read([*INI.splitlines(), *ini_settings.setting_lines(machine)])


@pytest.mark.parametrize(
    ("changed", "found", "dangerous"),
    [
        ({}, [], False),
        ({"[TRAJ]LINEAR_UNITS": "inch"}, [("[TRAJ]LINEAR_UNITS", "inch", "mm")], True),
        ({"[TRAJ]ANGULAR_UNITS": "rad"}, [("[TRAJ]ANGULAR_UNITS", "rad", "degree")], True),
        ({"joint_units 0": "INCH"}, [("joint_units 0", "INCH", "MM")], True),
        ({"joint_units 3": "DEG"}, [], False),
        ({"[AXIS_X]MAX_VELOCITY": "0"}, [("[AXIS_X]MAX_VELOCITY", "0", "{vx}")], True),
        ({"[AXIS_X]MAX_VELOCITY": "1"}, [("[AXIS_X]MAX_VELOCITY", "1", "{vx}")], False),
        ({"[JOINT_0]MAX_VELOCITY": "1"}, [("[JOINT_0]MAX_VELOCITY", "1", "{vx}")], False),
        ({"[JOINT_0]MAX_VELOCITY": "99999"}, [], False),
        ({"[AXIS_Y]MAX_LIMIT": "5"}, [("[AXIS_Y]MAX_LIMIT", "5", "{hy}")], False),
    ],
)
def test_an_ini_file_is_compared_with_the_machine_file(
    changed: dict[str, str], found: list[tuple[str, str, str]], dangerous: bool
) -> None:
    entries = ini(ROUTER) | changed
    required = ini_settings.requirements(ROUTER, entries)
    if dangerous:
        with pytest.raises(ControllerError) as refused:
            compare("lx", required, entries)
        differences = refused.value.message.arguments["differences"]
    else:
        differences = compare("lx", required, entries)
    figures = {"vx": f"{ROUTER.x.velocity:g}", "hy": f"{ROUTER.y.high:g}"}
    expected = [(name, value, wanted.format(**figures)) for name, value, wanted in found]
    assert [row[:3] for row in summary(tuple(differences))] == expected


async def test_a_machine_whose_z_would_home_downwards_does_not_home() -> None:
    wire = Wire({"$$": "$22=1\n$23=4\n$32=0\nok"}, state="Alarm")
    controller = Grbl(wire, safe=SAFE, silence=0.2, poll=0.02)
    with pytest.raises(ControllerError, match="locked"):
        await controller.open()
    with pytest.raises(ControllerError, match=r"\$23 is 4, expected 0: homing would drive"):
        await controller.home()
    assert "$H" not in wire.lines
    await controller.close()
