"""Programs that touch a keep-out zone are refused, move by move."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from knifetip.model.machine import Machine, Zone
from knifetip.verification.checks.motion.zones import _enters
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    DIELINE,
    GRBLHAL,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    changed,
)

#: A box between the crease and the contour of the handwritten program, lower than its travel.
ZONE = Zone("clamp", 20.0, 100.0, 30.0, 20.0, 15.0)


def codes(text: bytes, *zones: Zone, envelope: float = 0.0) -> list[str]:
    machine: Machine = replace(
        MACHINE,
        zones=zones,
        stations=tuple(replace(one, envelope=envelope) for one in MACHINE.stations),
    )
    found = verify(text, DIELINE, PLACEMENT, machine, BOARD).findings
    return [finding.message.code for finding in found]


@pytest.mark.parametrize("text", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])
def test_a_zone_beside_all_moves_gives_no_finding(text: bytes) -> None:
    assert codes(text, ZONE) == []


@pytest.mark.parametrize("text", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])
def test_a_holder_that_reaches_a_zone_beside_the_work_is_found(text: bytes) -> None:
    assert "verify.in-zone" in codes(text, ZONE, envelope=60.0)


@pytest.mark.parametrize("text", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])
def test_a_zone_on_an_arc_is_found_and_one_inside_it_is_not(text: bytes) -> None:
    # The corner of the contour at (120, 20) is an arc of 10 mm about (110, 30).
    on_arc = Zone("pin", 116.0, 22.0, 2.0, 2.0, 9.0)
    assert "verify.in-zone" in codes(text, on_arc)
    inside = Zone("pin", 109.0, 29.0, 2.0, 2.0, 9.0)
    assert codes(text, inside) == []


def test_an_arc_that_leaves_the_box_around_its_ends_is_found() -> None:
    # Half a circle of 20 mm from (110, 20) to (110, 60), which reaches X 130.
    half_circle = "G1 Z4.0000 F6000\nG3 X110.0000 Y60.0000 I0.0000 J20.0000 F24000"
    text = changed(LINUXCNC, "G1 X110.0000 F24000", f"G1 X110.0000 F24000\n{half_circle}")
    beside = Zone("pin", 128.0, 39.0, 2.0, 2.0, 9.0)
    assert "verify.in-zone" not in codes(LINUXCNC, beside)
    assert "verify.in-zone" in codes(text, beside)


def test_every_rapid_that_is_led_through_a_zone_below_its_top_is_refused() -> None:
    rapids = list(re.finditer(rb"G0 X-?[\d.]+ Y-?[\d.]+ Z20\.0000[^\n]*\n", LINUXCNC))
    assert rapids
    for match in rapids:
        low = b"G0 Z5.0000\nG0 X35.0000 Y110.0000\nG0 Z20.0000\n"
        high = b"G0 X35.0000 Y110.0000\n"
        for detour, refused in ((low, True), (high, False)):
            text = LINUXCNC[: match.start()] + detour + LINUXCNC[match.start() :]
            assert ("verify.in-zone" in codes(text, ZONE)) is refused


def test_a_lowered_turn_through_a_zone_is_refused_at_its_line() -> None:
    text = changed(LINUXCNC, "G1 X110.0000 F24000", "G1 X110.0000 F24000\nG0 Z4.0000\nG0 Y70.0000")
    through = Zone("pin", 109.0, 44.0, 2.0, 2.0, 9.0)
    assert "verify.in-zone" not in codes(LINUXCNC, through)
    assert "verify.in-zone" in codes(text, through)


@pytest.mark.parametrize("text", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])
def test_the_first_move_must_be_above_all_zones(text: bytes) -> None:
    far = Zone("far", 500.0, 500.0, 30.0, 20.0, 15.0)
    first = re.search(rb"G0 Z20.0000\n", text)
    assert first is not None
    assert codes(text, far) == []
    low = text.replace(first[0], b"G0 Z5.0000\n", 1)
    none = text.replace(first[0], b"", 1)
    assert "verify.unknown-beside-zone" in codes(low, far)
    assert "verify.unknown-beside-zone" in codes(none, far)
    assert "verify.unknown-beside-zone" not in codes(low)


def test_lines_enter_a_grown_zone_as_their_sampled_points_do() -> None:
    random = np.random.default_rng(5)
    zone = Zone("box", -1.0, -2.0, 3.0, 5.0, 9.0)
    start, end = random.uniform(-9.0, 9.0, (2, 3000, 2))
    end[::7] = start[::7]
    end[::5, 0] = start[::5, 0]
    found = _enters(start, end, 2.0, zone)
    fraction = np.linspace(0.0, 1.0, 2001)[:, None, None]
    points = start + (end - start) * fraction
    gap = np.maximum(np.maximum([-1.0, -2.0] - points, points - [2.0, 3.0]), 0.0)
    least = np.hypot(gap[..., 0], gap[..., 1]).min(axis=0)
    assert found[least < 2.0].all()
    assert not found[least > 2.01].any()
    assert 500 < found.sum() < 2500
