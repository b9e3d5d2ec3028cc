"""Programs with one changed digit: a change that moves the working tip is refused."""

import pytest

from knifetip.verification.verify import verify
from tests.support.examples import is_quick
from tests.support.programs import digit_mutation
from tests.support.programs.handwritten import (
    BOARD,
    DIELINE,
    GRBLHAL,
    LINUXCNC,
    MACHINE,
    PLACEMENT,
    changed,
)

#: Number of changed digits.
COUNT = 100 if is_quick() else 250


def refused(text: bytes) -> bool:
    return not verify(text, DIELINE, PLACEMENT, MACHINE, BOARD).accepted


@pytest.mark.parametrize(("text", "seed"), [(LINUXCNC, 1), (GRBLHAL, 2)], ids=["linuxcnc", "grbl"])
def test_every_digit_that_moves_the_working_tip_by_over_a_hundredth_is_refused(
    text: bytes, seed: int
) -> None:
    everything, caught, missed = digit_mutation.count_refusals(
        text, MACHINE, BOARD, refused, count=COUNT, seed=seed
    )
    accepted = [
        f"{kind}: {digit_mutation.changed_line(text, place, mutant)}"
        for kind, place, mutant in missed
        if kind in ("moved", "line", "output")
    ]
    assert accepted == []
    # The test is meaningful only if there are many changes to refuse.
    assert everything["moved"] > 0.24 * COUNT
    assert caught["moved"] == everything["moved"]
    # A feed that differs in its sixth figure is the same feed.
    assert caught["feed"] >= 0.9 * everything["feed"]


@pytest.mark.parametrize(
    ("old", "new", "kind"),
    [
        ("Y65.6000 F30000", "Y65.9000 F30000", "moved"),
        ("Y65.6000 F30000", "Y65.6001 F30000", "smaller"),
        ("Y65.6000 F30000", "Y65.6000 F31000", "feed"),
        ("(station 2 Wheel)", "(station 3 Wheel)", "comment"),
        ("Y34.4000 Z20.0000", "Y34.4000 Z21.0000", "air"),
        ("Y34.4000 Z20.0000 C90", "Y34.4000 Z20.0000 C91", "moved"),
        ("T2 M6 G43", "T3 M6 G43", "moved"),
        ("M3 S1", "M3 S2", "output"),
        ("G64 P0.0050", "G64 P0.0070", "rounding"),
        ("G1 Y65.6000", "G0 Y65.6000", "moved"),
        ("G1 X70.0000\n", "G1 X69.0000\n", "smaller"),
        ("G3 X120.0000", "G2 X120.0000", "moved"),
        ("J10.0000", "J10.0001", "smaller"),
    ],
)
def test_the_effect_of_a_change_is_computed_without_the_verifier(
    old: str, new: str, kind: str
) -> None:
    mutant = changed(LINUXCNC, old, new)
    place = next(i for i, (a, b) in enumerate(zip(LINUXCNC, mutant, strict=True)) if a != b)
    assert digit_mutation.effect(LINUXCNC, place, mutant, MACHINE, BOARD) == kind


def test_a_point_moved_along_its_line_is_not_counted_as_a_change() -> None:
    # The end of the contour and the overrun are collinear: 70 is only the point where they meet.
    mutant = changed(LINUXCNC, "G1 X70.0000\n", "G1 X70.2000\n")
    place = next(i for i, (a, b) in enumerate(zip(LINUXCNC, mutant, strict=True)) if a != b)
    assert digit_mutation.effect(LINUXCNC, place, mutant, MACHINE, BOARD) in ("air", "smaller")
    assert not refused(mutant)
