import time
from dataclasses import replace
from typing import cast

import numpy as np
import pytest

from knifetip.errors import GeometryError, ProgramError, ProgramUnreadable
from knifetip.model.dieline import LineType
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.verify import verify
from tests.support.programs.handwritten import (
    BOARD,
    CONTOUR,
    CUT,
    DIELINE,
    FOLD,
    GRBLHAL,
    HALF,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    SLIT,
    changed,
    dieline,
    knife_program,
)
from tests.support.shapes import with_dimensions

BOTH = pytest.mark.parametrize("text", [LINUXCNC, GRBLHAL], ids=["linuxcnc", "grblhal"])


@BOTH
def test_the_hand_written_programs_are_accepted(text: bytes) -> None:
    verdict = verify(text, DIELINE, PLACEMENT, MACHINE, BOARD)
    assert verdict.findings == ()
    assert verdict.accepted


@BOTH
def test_the_figures_equal_those_computed_by_hand(text: bytes) -> None:
    verdict = verify(text, DIELINE, PLACEMENT, MACHINE, BOARD)
    rounds = 0.005 if text is LINUXCNC else 0.0
    worked = np.arange(len(DIELINE)) < 13
    np.testing.assert_allclose(verdict.deviation, np.where(worked, rounds, 0.0), atol=1e-9)
    np.testing.assert_array_equal(verdict.uncut, 0.0)
    setback = np.zeros(len(DIELINE))
    setback[[SLIT, FOLD, HALF]] = 0.40555, 8.8, 0.17633
    np.testing.assert_allclose(verdict.setback, setback, atol=1e-5)
    np.testing.assert_array_equal(verdict.overcut[list(CONTOUR)], 0.0)


@BOTH
def test_the_deviation_includes_the_fit_of_the_curve_that_an_edge_approximates(text: bytes) -> None:
    rounds = 0.005 if text is LINUXCNC else 0.0
    worked = np.arange(len(DIELINE)) < 13
    fit = np.where(np.arange(len(DIELINE)) % 2 == 0, 0.004, 0.0)
    verdict = verify(text, replace(DIELINE, fit_error=fit), PLACEMENT, MACHINE, BOARD)
    assert verdict.accepted
    for column, value in (
        (verdict.path_deviation, 0.0),
        (verdict.blending, rounds),
        (verdict.fit_error, fit),
        (verdict.deviation, rounds + fit),
    ):
        np.testing.assert_allclose(column, np.where(worked, value, 0.0), atol=1e-9)


@BOTH
@pytest.mark.parametrize("edge", [SLIT, FOLD, HALF, CONTOUR[0]])
def test_a_fit_that_exceeds_the_tolerance_with_the_program_is_refused(
    text: bytes, edge: int
) -> None:
    rounds = 0.005 if text is LINUXCNC else 0.0
    fit = np.zeros(len(DIELINE))
    for share, accepted in ((0.99, True), (1.05, False)):
        fit[edge] = share * (0.01 - rounds)
        verdict = verify(text, replace(DIELINE, fit_error=fit), PLACEMENT, MACHINE, BOARD)
        assert verdict.accepted == accepted
        codes = {(finding.message.code, finding.edge) for finding in verdict.findings}
        assert codes == (set() if accepted else {("verify.off-curve", edge)})


def test_both_dialects_take_the_same_time() -> None:
    one, other = (verify(text, DIELINE, PLACEMENT, MACHINE, BOARD) for text in (LINUXCNC, GRBLHAL))
    assert one.seconds == pytest.approx(other.seconds, abs=1e-5)


@pytest.mark.parametrize(
    "other",
    [
        {"back": 6.1},
        {"half_width": 1.6},
        {"tilt": 44.0},
    ],
)
def test_a_program_for_another_v_cutter_is_refused(other: dict[str, float]) -> None:
    stations = tuple(
        replace(held, tool=with_dimensions(held.tool, **other)) if held.number == 3 else held
        for held in MACHINE.stations
    )
    machine = replace(MACHINE, stations=stations)
    assert not verify(LINUXCNC, DIELINE, PLACEMENT, machine, BOARD).accepted


@pytest.mark.parametrize("column", ["x", "y", "z", "c"])
@pytest.mark.parametrize("text", [GRBLHAL])
def test_a_program_with_another_datum_in_its_numbers_is_refused(text: bytes, column: str) -> None:
    stations = tuple(
        replace(held, **{column: getattr(held, column) + 0.2}) for held in MACHINE.stations
    )
    machine = replace(MACHINE, stations=stations)
    assert not verify(text, DIELINE, PLACEMENT, machine, BOARD).accepted


def test_a_tool_table_brings_its_own_datum() -> None:
    stations = tuple(replace(held, x=held.x + 5.0, c=held.c + 30.0) for held in MACHINE.stations)
    machine = replace(MACHINE, stations=stations)
    assert verify(LINUXCNC, DIELINE, PLACEMENT, machine, BOARD).accepted


def test_another_placement_is_refused_with_both_in_the_message() -> None:
    verdict = verify(LINUXCNC, DIELINE, (20.0, 21.0), MACHINE, BOARD)
    assert not verdict.accepted
    both = "X20.0000 Y20.0000 on the sheet, but the job places it at X20.0000 Y21.0000"
    assert any(both in finding.text for finding in verdict.findings)


def test_an_unclassified_edge_is_refused() -> None:
    kinds = DIELINE.line_type.copy()
    kinds[13] = LineType.UNCLASSIFIED
    verdict = verify(LINUXCNC, replace(DIELINE, line_type=kinds), PLACEMENT, MACHINE, BOARD)
    assert [(finding.kind, finding.edge) for finding in verdict.findings] == [("uncut", 13)]


@pytest.mark.parametrize(
    "text",
    [b"", b"\n", b"()", b"M2\n", b"G0 X1\n", bytes(range(256)), b"G1 " * 10_000, b"\xff" * 1000],
)
def test_a_text_that_is_not_a_program_is_refused_without_an_exception(text: bytes) -> None:
    verdict = verify(text, DIELINE, PLACEMENT, MACHINE, BOARD)
    assert not verdict.accepted
    assert verdict.uncut[0] == 80.0


def test_scrambled_programs_raise_no_exception() -> None:
    chance = np.random.default_rng(11)
    for _ in range(150):
        raw = np.frombuffer(LINUXCNC, np.uint8).copy()
        places = chance.integers(0, len(raw), 8)
        raw[places] = chance.choice(np.frombuffer(b"0123456789.-GMXYZCIJFPTS \n()", np.uint8), 8)
        verify(raw.tobytes(), DIELINE, PLACEMENT, MACHINE, BOARD)


def test_invalid_arguments_raise_an_error_with_the_reason() -> None:
    with pytest.raises(ProgramUnreadable):
        verify(cast(bytes, "G0"), DIELINE, PLACEMENT, MACHINE, BOARD)
    with pytest.raises(GeometryError, match="The placement"):
        verify(LINUXCNC, DIELINE, (float("nan"), 0.0), MACHINE, BOARD)
    with pytest.raises(GeometryError, match="Edge 1 has a coordinate"):
        verify(LINUXCNC, dieline((CUT, 0, 0, 1, 0, 0), (CUT, 0, 0, np.inf, 0, 0)), PLACEMENT,
               MACHINE, BOARD)  # fmt: skip
    for tolerance in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(ProgramError, match="is not a valid length"):
            verify(LINUXCNC, DIELINE, PLACEMENT, MACHINE, BOARD, tolerance=tolerance)


def test_at_most_a_thousand_findings_are_kept() -> None:
    drawn = dieline(*((CUT, 0.0, float(y), 5.0, float(y), 0.0) for y in range(1500)))
    verdict = verify(LINUXCNC, drawn, PLACEMENT, MACHINE, BOARD)
    assert len(verdict.findings) == MAX_FINDINGS
    assert verdict.uncut[1499] == 5.0


def test_a_wider_tolerance_accepts_greater_deviations() -> None:
    text = LINUXCNC.decode().replace("Y35.0000", "Y35.0300").encode()
    assert not verify(text, DIELINE, PLACEMENT, MACHINE, BOARD).accepted
    assert verify(text, DIELINE, PLACEMENT, MACHINE, BOARD, tolerance=0.05).accepted


def test_findings_are_sorted_by_line() -> None:
    text = changed(LINUXCNC, "G1 X59.5944 F24000", "G1 X59.4000 F24000")
    text = changed(text, "G1 Y65.6000 F30000", "G1 Y65.0000 F30000")
    lines = [finding.line for finding in verify(text, DIELINE, PLACEMENT, MACHINE, BOARD).findings]
    assert lines == sorted(lines)
    assert len(lines) >= 2


def test_ten_times_the_moves_take_no_more_than_thirty_times_as_long() -> None:
    def seconds(rows: int) -> float:
        edges, lines = [], ["G0 X0 Y0 Z20 C0", "G0 Z4"]
        for row in range(rows):
            x, y = 25.0 * (row % 25), 0.0125 * row
            edges.append((CUT, x, y, x + 20.0, y, 0.0))
            lines += [f"G0 X{x:.4f} Y{y:.4f}", "G1 Z-0.3 F6000", f"G1 X{x + 19.5944:.4f} F24000",
                      "G1 Z4 F6000"]  # fmt: skip
        drawn, text = dieline(*edges), knife_program(*lines)
        found = verify(text, drawn, (0.0, 0.0), MACHINE, BOARD).findings
        # The lines are 0.0125 mm apart, which a person may accept.
        assert {one.message.code for one in found} == {"verify.drawn-twice"}
        begin = time.process_time()
        verify(text, drawn, (0.0, 0.0), MACHINE, BOARD)
        return time.process_time() - begin

    # A comparison of every move with every edge would take a hundred times as long.
    assert seconds(20_000) < 30.0 * seconds(2_000) + 0.1


@BOTH
def test_a_cut_is_not_repeated_on_loose_board(text: bytes) -> None:
    slit = "G0 X40.0000 Y35.0000 C0.0000\nG1 Z-0.3000\nG1 X59.5944 F24000\nG1 Z4.0000 F6000\n"
    last = "G1 X70.3527\nG1 Z4.0000 F6000\n"
    found = verify(changed(text, last, last + slit), DIELINE, PLACEMENT, MACHINE, BOARD).findings
    assert [(each.message.code, each.edge) for each in found] == [("verify.loose-piece", SLIT)]
    before = "G0 X70.0000 Y20.0000 C0.0000\n"
    again = changed(text, before, slit + before)
    assert verify(again, DIELINE, PLACEMENT, MACHINE, BOARD).findings == ()
