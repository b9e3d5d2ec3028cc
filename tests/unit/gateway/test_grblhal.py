"""What real grblHAL answered: recorded with grblHAL 1.1f.20260817 on its simulator 260324.

The simulator was built with 3, 4 and 6 axes and with 8 auxiliary outputs.
"""

from __future__ import annotations

import pytest

from knifetip.gateway.controller import State
from knifetip.gateway.grbl import answers
from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.library import load
from knifetip.simulators.grbl.firmware import Firmware
from knifetip.simulators.grbl.table import Table

OPTIONS = """[VER:1.1f.20260817:]
[OPT:VNML+,100,1024,{count},0]
[AXS:{count}:{axes}]
[NEWOPT:ENUMS,RT+,TC,SED]
[FIRMWARE:grblHAL]
[SIGNALS:D]
[NVS STORAGE:*EEPROM]
[DRIVER:Simulator]
[DRIVER VERSION:260324]
[AUX IO:0,8,0,0]"""


@pytest.mark.parametrize(
    ("axes", "letter", "index"),
    [("XYZ", "", 3), ("XYZC", "C", 3), ("XYZA", "A", 3), ("XYZABC", "C", 5)],
)
def test_the_options_of_four_builds(axes: str, letter: str, index: int) -> None:
    lines = OPTIONS.format(count=len(axes), axes=axes).split("\n")
    found = Capabilities.read(lines, len(axes))
    assert (found.axes, found.outputs, found.blocks, found.buffer) == (axes, 8, 100, 1024)
    assert (found.rotary_letter, found.rotary_axis) == (letter, index)


@pytest.mark.parametrize(
    ("line", "state", "still", "machine", "room"),
    [
        (
            "<Idle|MPos:0.000,0.000,20.000,0.000|Bf:100,1023|FS:0,0|Ov:100,100,100|A:|H:0|TLR:0>",
            State.IDLE,
            True,
            (0.0, 0.0, 20.0, 0.0),
            1023,
        ),
        (
            "<Run|MPos:59.650,0.000,0.000,0.000,0.000,17.900|Bf:99,1023|FS:6000,0|A:S>",
            State.RUN,
            False,
            (59.65, 0.0, 0.0, 17.9),
            1023,
        ),
        (
            "<Hold:1|MPos:65.650,0.000,0.000,0.000,0.000,19.700|Bf:99,1023|FS:0,0"
            "|WCO:0.000,0.000,0.000,0.000,0.000,0.000>",
            State.HOLD,
            False,
            (65.65, 0.0, 0.0, 19.7),
            1023,
        ),
        (
            "<Hold:0|MPos:98.650,0.000,0.000,0.000,0.000,29.600|Bf:99,1023|FS:6000,0>",
            State.HOLD,
            True,
            (98.65, 0.0, 0.0, 29.6),
            1023,
        ),
        (
            "<Door:1|MPos:99.350,0.000,0.000,0.000,0.000,29.600|Bf:100,1023|FS:0,0|Pn:D|A:>",
            State.DOOR,
            True,
            (99.35, 0.0, 0.0, 29.6),
            1023,
        ),
        (
            "<Alarm|MPos:-1795.000,-1295.000,-0.230,0.000,0.000,0.000|Bf:100,1023|FS:0,0|Pn:Z|A:>",
            State.ALARM,
            True,
            (-1795.0, -1295.0, -0.23, 0.0),
            1023,
        ),
        (
            "<Home|MPos:0.000,0.000,20.000,0.000,0.000,0.000|Bf:100,1023|FS:0,0>",
            State.HOME,
            False,
            (0.0, 0.0, 20.0, 0.0),
            1023,
        ),
    ],
)
def test_status_reports(
    line: str, state: State, still: bool, machine: tuple[float, ...], room: int
) -> None:
    axes = line.split("MPos:")[1].split("|")[0].count(",")
    found = answers.report(line, axes)
    assert found is not None
    assert (found.state, found.still, found.machine, found.free_bytes) == (
        state,
        still,
        machine,
        room,
    )


#: Lines sent one by one to a build with the axes XYZC, each with its answer.
EXCHANGE = """
G21 G90 G91.1 G17 G40 G49 G94 G54 G92.1 | ok
M64 P1 | ok
M64 P9 | error:39
M65 P1 | error:39
(a comment) | error:39
;a comment | error:39
| ok
M65 P1 | ok
M64 P9 | error:39
$G | ok
M65 P1 | ok
G1 X5 | error:22
| ok
F100 | ok
G1 X5 F | error:2
| ok
G0 X5 X6 | error:25
| ok
G41 | error:20
| ok
G2 X2 Y2 | error:35
| ok
G93 | ok
G1 X3 | error:22
| ok
G94 | ok
G4 | error:28
| ok
G0 C5 | ok
(only a comment) | ok
M3 S1 | ok
M5 | ok
G10 L20 P1 X0 | ok
G0 X--1 | error:2
| ok
$J=G91 X1 F1000 | ok
$Q | error:3
$C | ok
G0 X10 | ok
G1 Y | error:2
G0 X10 | error:2
| ok
M65 P1 | ok
$C | ok
$X | ok
"""


def test_the_simulated_table_answers_like_grblhal() -> None:
    table = Table(load.machine("demo-table"), firmware=Firmware("XYZC", outputs=8))
    heard: list[str] = []
    table.answer = heard.append
    for row in EXCHANGE.strip("\n").split("\n"):
        line, _, answer = row.partition("| ")
        heard.clear()
        table.receive(line.strip().encode() + b"\n")
        table.elapse(5.0)
        final = [one for one in heard if one == "ok" or one.startswith("error")]
        assert final == [answer], (row, heard)
