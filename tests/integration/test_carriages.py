"""Machines with several carriages: their programs are accepted, and wrong ones are refused."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.errors import ControllerError, LibraryError, TravelExceeded
from knifetip.languages.registry import find_language, with_language
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.machine import Axis, Carriage, Gantry, Machine, Zone
from knifetip.model.tool import Laser
from knifetip.sequencing.duration import duration, durations
from knifetip.sequencing.travel import carriage_changes
from knifetip.simulators.grbl.table import Table
from knifetip.verification.verify import trace_program, verify
from tests.support.shapes import closed, dieline, edges
from tests.support.verdicts import has_faults

TABLE = load.machine("two-carriage-table")
BOARD = load.board("greyboard-2.0")
#: Each tool makes a line; the crease and the cut contain an arc.
LINE = dieline(
    (LineType.V_GROOVE, edges(((110, 200), (290, 200)))),
    (LineType.CREASE, edges(((110, 150), (200, 150)), ((200, 150), (250, 150)))),
    (LineType.CUT, closed((100, 100), (300, 100), (300, 300), (100, 300))),
    bulge={2: 0.3, 3: 0.1},
)
DIALECTS = ("linuxcnc", "grblhal")


def own_z(machine: Machine = TABLE) -> Machine:
    """Return the machine with a Z of its own, W, for its second carriage."""
    assert machine.gantry
    first, second = machine.gantry.carriages
    x, y, _, c = second.axes
    lift = Axis(-12.0, 50.0, 300.0, 3000.0)
    letters = f"X{second.letters[1]}W{second.letters[3]}"
    further = Carriage((x, y, lift, c), letters, second.park)
    return replace(machine, gantry=replace(machine.gantry, carriages=(first, further)))


MACHINES = {"shared Z": TABLE, "own Z": own_z()}


def program(machine: Machine = TABLE, dialect: str = "linuxcnc", line: Dieline = LINE) -> str:
    toolpath = sequence([compensate(one) for one in plan(line, machine, BOARD)], machine)
    return process(toolpath, machine, dialect).text.decode()


def faults(text: str, machine: Machine = TABLE) -> list[str]:
    result = verify(text.encode(), LINE, (0.0, 0.0), machine, BOARD)
    assert has_faults(result) == bool(result.findings)
    return [finding.message.code for finding in result.findings]


def changed(text: str, old: str, new: str) -> str:
    """Return a program with the first match of a pattern replaced."""
    result, count = re.subn(old, new, text, count=1, flags=re.MULTILINE)
    assert count == 1, old
    return result


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("name", MACHINES)
def test_all_tools_of_both_carriages_are_accepted(name: str, dialect: str) -> None:
    machine = MACHINES[name]
    text = program(machine, dialect)
    assert faults(text, machine) == []
    moves, _, _ = trace_program(text.encode(), machine, BOARD)
    assert set(moves.station.tolist()) >= {0, 1, 2}


def test_grblhal_calls_the_axes_of_the_second_carriage_a_and_b() -> None:
    first, second = TABLE.carriages
    gantry = Gantry((first, replace(second, letters="XAZB")), 200.0)
    machine = replace(TABLE, gantry=gantry, dialect="grblhal")
    text = program(machine, "grblhal")
    assert faults(text, machine) == []
    assert text == program(TABLE, "grblhal").translate(str.maketrans("VA", "AB"))


def test_each_station_has_the_words_of_its_carriage() -> None:
    parts = re.split(r"^\(station (\d).*\)$", program(), flags=re.MULTILINE)[1:]
    letters = {
        number: set(re.findall(r" ([A-EH-LN-Z])-?\d", body.split("M65")[1].split("G49")[0]))
        for number, body in zip(parts[::2], parts[1::2], strict=True)
        if "M65" in body
    }
    assert letters["1"] >= set("XYZC")
    assert not letters["1"] & set("VA")
    for number in "23":
        if number in letters:
            assert letters[number] >= set("XVZA")
            assert not letters[number] & set("YC")


def test_all_carriages_are_parked_at_the_start_and_each_before_another_moves() -> None:
    moves, _, _ = trace_program(program().encode(), TABLE, BOARD)
    column = {"Y": 1, "V": 4}
    park = {carriage.letters[1]: carriage.park for carriage in TABLE.carriages}
    assert list(TABLE.axes) == ["X", "Y", "Z", "C", "V", "A"]
    first = np.flatnonzero(~np.isnan(moves.axes_end[:, 1]))[0]
    assert moves.axes_end[first, [1, 4]].tolist() == [park["Y"], park["V"]]
    after = moves.axes_end[first:]
    away = [after[:, column[letter]] != park[letter] for letter in "YV"]
    assert away[0].any()
    assert away[1].any()
    assert not (away[0] & away[1]).any()


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        # Carriage 2 stays where it worked while carriage 1 comes.
        (r"^G0 V14\S+\n", "", "verify.heads-too-near"),
        # The first carriage is sent beside the parked second one, and back.
        (r"^(G0 X\S+ Y[1-9].*)$", r"\1\nG0 V290.0000\nG0 V1420.0000", "verify.heads-too-near"),
        # The carriages are not parked.
        (r"^G0 Y-220\.0000 V1420\.0000\n", "", "verify.head-not-located"),
        # They are parked one after the other, so that the first may meet the second.
        (
            r"^G0 Y-220\.0000 V1420\.0000$",
            "G0 Y-220.0000\nG0 V1420.0000",
            "verify.head-not-located",
        ),
        # The idle carriage is moved at a feed.
        (r"^(G93 G1 X\S+ V\S+ A\S+)", r"\1 Y-219.0000", "rs274.moves-other-carriage"),
        # Beyond the travel of V, and beyond that of A.
        (r"^(G0 V14\S+)$", r"G0 V1430.0000\n\1", "verify.beyond-travel"),
        (r"^(G0 V14\S+)$", r"\1 A800.0000\nG0 A0.0000", "verify.beyond-rotation"),
        # A feed along V has no time.
        (r"^G93 (G1 V\S+ Z\S+) F\S+$", r"G94 \1 F3000", "verify.feed-of-other-axis"),
    ],
)
def test_a_wrong_program_is_refused(old: str, new: str, code: str, dialect: str) -> None:
    assert any(code in fault for fault in faults(changed(program(TABLE, dialect), old, new)))


def test_an_arc_of_the_second_carriage_is_refused() -> None:
    text = changed(
        program(),
        r"^(T2 M6 G43\n(?:.*\n)*?)(G93 G1 X\S+ V\S+ A\S+ F\S+)$",
        r"\1\2\nG2 X200.0000 Y150.0000 I20.0000 J0.0000",
    )
    assert "rs274.arc-of-other-carriage" in faults(text)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_an_idle_head_with_its_own_z_must_be_lifted(dialect: str) -> None:
    machine = MACHINES["own Z"]
    text = program(machine, dialect)
    # The last lift of carriage 2 before the knife: its crease wheel and V-cutter are up then.
    lowered = changed(text, r"^(?=.*M64 P0)", "G0 W5.0000\n")
    assert "verify.idle-head-low" in faults(lowered, machine)


def test_a_carriage_rests_where_its_longest_station_clears_the_board() -> None:
    machine = MACHINES["own Z"]
    # Only the wheel works on carriage 2; the V-cutter beside it reaches 1.5 mm lower.
    line = dieline(
        (LineType.CREASE, edges(((100, 150), (300, 150)))),
        (LineType.CUT, closed((100, 100), (300, 100), (300, 300), (100, 300))),
    )
    text = program(machine, line=line).encode()
    moves, _, _ = trace_program(text, machine, BOARD)
    height = moves.axes_end[moves.station == 0, list(machine.axes).index("W")]
    assert (height == machine.travel_z).all()
    assert not verify(text, line, (0.0, 0.0), machine, BOARD).findings


def test_all_heads_are_lifted_before_outputs_are_released() -> None:
    machine = MACHINES["own Z"]
    text = program(machine)
    assert re.search(r"^G0 Z20\.0000 W20\.0000$", text, re.MULTILINE)
    low = changed(text, r"^G0 Z20\.0000 W20\.0000$", "G0 Z20.0000 W5.0000")
    assert "verify.switches-low" in faults(low, machine)
    assert "verify.moves-before-stated" in faults(low, machine)
    half = changed(text, r"^G0 Z20\.0000 W20\.0000$", "G0 Z20.0000")
    assert "verify.switches-at-unknown-height" in faults(half, machine)


def test_a_station_is_lowered_only_if_its_own_carriage_is_lifted() -> None:
    machine = MACHINES["own Z"]
    knife, *others = machine.stations
    stations = (replace(knife, carriage=2), *(replace(one, carriage=1) for one in others))
    exchanged = replace(machine, stations=stations)
    text = program(exchanged)
    assert faults(text, exchanged) == []
    low = changed(text, r"^(?=\(station 1)", "G0 W3.0000\n")
    assert set(faults(low, exchanged)) == {"verify.idle-head-low", "verify.switches-low"}


def test_work_beside_a_parked_carriage_is_refused_before_a_program_is_written() -> None:
    assert TABLE.gantry
    carriages = tuple(
        replace(one, axes=(one.axes[0], Axis(-300.0, 1500.0, 900.0, 4000.0), *one.axes[2:]))
        for one in TABLE.carriages
    )
    longer = replace(TABLE, gantry=replace(TABLE.gantry, carriages=carriages))
    far = replace(LINE, ends=LINE.ends + np.array([0.0, 930.0]))
    with pytest.raises(
        TravelExceeded,
        match=r"knife .* would come as near as 1\d\d.* mm to the parked carriage 2",
    ):
        program(longer, line=far)
    near = replace(LINE, ends=LINE.ends - np.array([0.0, 180.0]))
    with pytest.raises(
        TravelExceeded, match=r"Crease wheel .* as near as 1\d\d.* mm to the parked carriage 1"
    ):
        program(longer, line=near)


def test_the_verifier_checks_the_least_distance_of_the_machine() -> None:
    assert TABLE.gantry
    wider = replace(TABLE, gantry=replace(TABLE.gantry, min_distance=1150.0))
    assert "verify.heads-too-near" in faults(program(), wider)


def test_the_distance_is_checked_along_the_whole_of_an_arc() -> None:
    round_top = closed((100, 100), (300, 100), (300, 300), (100, 300))
    line = dieline((LineType.CUT, round_top), bulge={2: 0.1})
    text = program(line=line).encode()
    assert TABLE.gantry
    # The arc begins and ends 1,120 mm from the parked carriage, and reaches up to 1,110 mm.
    for least, accepted in ((1105.0, True), (1115.0, False)):
        machine = replace(TABLE, gantry=replace(TABLE.gantry, min_distance=least))
        found = verify(text, line, (0.0, 0.0), machine, BOARD).findings
        codes = {finding.message.code for finding in found}
        assert codes == (set() if accepted else {"verify.heads-too-near"})


def test_arcs_of_the_second_carriage_are_chords_near_the_arc() -> None:
    text = program()
    wheel = text.split("T2 M6 G43")[1].split("M65")[0]
    assert len(re.findall(r"^G93 G1 X\S+ V\S+ A\S+", wheel, re.MULTILINE)) > 20
    assert "G2" not in wheel
    assert "G3 " not in wheel
    result = verify(text.encode(), LINE, (0.0, 0.0), TABLE, BOARD)
    assert result.deviation.max() < 0.0062


@pytest.mark.parametrize("limit", [{"velocity": 100.0}, {"acceleration": 400.0}])
def test_the_speeds_of_a_carriage_count_in_the_time(limit: dict[str, float]) -> None:
    toolpath = sequence([compensate(one) for one in plan(LINE, TABLE, BOARD)], TABLE)
    assert TABLE.gantry
    first, second = TABLE.gantry.carriages
    x, y, z, c = second.axes
    slow = replace(second, axes=(x, replace(y, **limit), z, c))
    slower = replace(TABLE, gantry=replace(TABLE.gantry, carriages=(first, slow)))
    assert duration(toolpath, slower) > 1.1 * duration(toolpath, TABLE)
    fast = replace(second, axes=(x, replace(y, **dict.fromkeys(limit, 20_000.0)), z, c))
    faster = replace(TABLE, gantry=replace(TABLE.gantry, carriages=(first, fast)))
    assert duration(toolpath, faster) < 0.98 * duration(toolpath, TABLE)


def test_a_parked_carriage_need_not_travel_to_its_parking_position() -> None:
    toolpath = sequence([compensate(one) for one in plan(LINE, TABLE, BOARD)], TABLE)
    rows = carriage_changes(toolpath, TABLE)
    assert len(rows) == 1
    # The row leads over 1.6 m in the toolpath, which would take more than a second.
    assert np.ptp(toolpath.pose[rows[0] : rows[0] + 2, 1]) > 1600.0
    assert durations(toolpath, TABLE)[rows[0]] < 0.5


def test_a_clamp_between_two_parked_carriages_is_not_in_the_way_of_a_change() -> None:
    toolpath = sequence([compensate(one) for one in plan(LINE, TABLE, BOARD)], TABLE)
    x = float(toolpath.pose[carriage_changes(toolpath, TABLE)[0], 0])
    clamp = Zone("Clamp", x - 20.0, 700.0, 40.0, 60.0, 25.0)
    clamped = replace(TABLE, zones=(clamp,))
    text = program(clamped)
    # The carriage in use goes over the clamp to its parking position.
    assert text.count("G0 Z27.0000") == 1
    # The clamp is higher than the travel height, so only the first moves are below its top.
    assert set(faults(text, clamped)) == {"verify.unknown-beside-zone"}


def test_a_laser_on_the_second_carriage_is_switched_with_its_own_letters() -> None:
    machine = own_z()
    laser = Laser(0.2, 6000.0, power=500.0, pierce=0.2)
    knife, *others = machine.stations
    held = replace(knife, tool=laser, carriage=2)
    lasing = replace(machine, stations=(held, *others))
    text = program(lasing)
    assert re.search(r"^G1 W[\d.]+ F6000\nM3 S500$", text, re.MULTILINE)
    assert faults(text, lasing) == []


def test_hpgl_and_short_alphabets_are_refused_with_the_reason() -> None:
    with pytest.raises(LibraryError, match="linear axis V, but HPGL has no such axis"):
        with_language(TABLE, "hpgl")
    with pytest.raises(LibraryError, match="linear axis W, but grblHAL has no such axis"):
        with_language(MACHINES["own Z"], "grblhal")


def test_neither_gateway_nor_simulated_table_drives_several_carriages() -> None:
    with pytest.raises(ControllerError, match="has 2 carriages"):
        find_language("grblhal").load_driver(replace(TABLE, dialect="grblhal"))
    with pytest.raises(ControllerError, match="has 2 carriages"):
        Table(replace(TABLE, dialect="grblhal"))


def test_three_carriages_keep_their_order() -> None:
    assert TABLE.gantry
    first, second = TABLE.gantry.carriages
    x, _, z, c = second.axes
    middle = Carriage((x, Axis(-300.0, 1500.0, 900.0, 4000.0), z, c), "XUZB", 700.0)
    gantry = Gantry((first, middle, second), 200.0)
    machine = replace(TABLE, gantry=gantry)
    # The knife may not pass below the parked middle carriage.
    with pytest.raises(TravelExceeded, match="carriage 2"):
        program(machine, line=replace(LINE, ends=LINE.ends + np.array([0.0, 300.0])))
    stations = tuple(
        replace(station, carriage={1: 1, 2: 3, 3: 3}[station.number])
        for station in machine.stations
    )
    with pytest.raises(TravelExceeded, match="carriage 2"):
        program(replace(machine, stations=stations))
    parks = sorted(carriage.park for carriage in gantry.carriages)
    assert all(far - near >= gantry.min_distance for near, far in pairwise(parks))
