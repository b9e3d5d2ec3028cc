"""A short attack on the verifier: no mutant that does damage is accepted.

``python -m tests.attack`` runs longer ones.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.attack.campaign import Tally, run
from tests.attack.damage import Oracle
from tests.attack.rests import rests
from tests.attack.subjects import Subject, subjects
from tests.support.examples import is_quick

#: Number of mutants of each attack.
MUTANTS = 90 if is_quick() else 300


@pytest.mark.parametrize("seed", [11, pytest.param(12, marks=pytest.mark.long)])
def test_no_damaging_mutant_is_accepted(seed: int) -> None:
    tally = Tally()
    escaped = [str(escape) for escape in run(subjects(), MUTANTS, seed, tally)]
    assert escaped == []
    fates = sum((fates for fates in tally.fates.values()), start=tally.kinds["none"])
    assert fates["harmless"] > MUTANTS // 30
    assert fates["refused"] > MUTANTS // 2


def test_no_damaging_mutant_of_a_rest_is_accepted() -> None:
    tally = Tally()
    assert [str(escape) for escape in run(rests(), MUTANTS * 2 // 3, 21, tally)] == []
    fates = sum((fates for fates in tally.fates.values()), start=tally.kinds["none"])
    assert fates["harmless"] > MUTANTS // 60
    assert fates["refused"] > MUTANTS // 3


def _named(name: str) -> Subject:
    return next(subject for subject in subjects() if subject.name == name)


def test_a_rest_is_measured_with_what_earlier_programs_have_cut() -> None:
    subject = next(each for each in rests() if each.name == "rest half, demo-table, grblhal")
    oracle, (work,) = Oracle(subject), subject.earlier
    assert oracle.damage(subject.text) == ""
    # The part whose outline was cut before must not be worked again.
    cut = replace(subject, earlier=(replace(work, text=subject.text, repeated=((1, 999),)),))
    window = subject.text.index(b"G1 X100.0000")
    turned = subject.text[:window] + b"G1 X100.0001" + subject.text[window + 12 :]
    assert oracle.damage(turned) == ""
    assert "works on a part after its outline" in Oracle(cut).damage(turned)
    assert not cut.accepts(subject.text)


@pytest.mark.parametrize(
    ("name", "old", "new", "damage"),
    [
        ("knife, grblhal", b"G4 P0\nM65 P0", b"M65 P0", "switches while the head moves"),
        ("knife, linuxcnc", b"G4 P0\nG3", b"G3", "without a stop"),
        ("knife, linuxcnc", b"M65 P1\n", b"", "beside [1]"),
        ("knife, linuxcnc", b"G21 ", b"", "units"),
        ("knife, linuxcnc", b"G1 Z-0.3000", b"G1 Z-0.3200", "0.0200 mm"),
        ("knife, linuxcnc", b"M2\n", b"G91\nM2\n", "not supported"),
        ("crease, linuxcnc", b"M64 P1", b"M64 P2", "beside [2]"),
        ("V-groove, grblhal", b"C0.0000", b"C2.0000", "is off by"),
        ("router B, linuxcnc", b"S18000", b"S9000", "spindle at 9000"),
        ("router B, linuxcnc", b"G64 P0.0005", b"G64 P0.0500", "rounded by 0.05 mm"),
        ("flat cutter, hpgl", b"FS12;", b"FS30;", "force 30"),
    ],
)
def test_each_kind_of_damage_is_found(name: str, old: bytes, new: bytes, damage: str) -> None:
    subject = _named(name)
    assert old in subject.text
    oracle = Oracle(subject)
    assert oracle.damage(subject.text) == ""
    assert damage in oracle.damage(subject.text.replace(old, new, 1))


@pytest.mark.parametrize(("end", "damage"), [(b"Y179.2000", ""), (b"Y179.5000", "is off by")])
def test_a_reversed_blade_does_no_damage_within_its_slit(end: bytes, damage: str) -> None:
    subject = _named("bridges, grblhal")
    last = b"G1 Y167.4722 F9000\nG1 Z4.0000 F6000\n"
    assert last in subject.text
    back = last + b"G0 C90.0000\nG1 Z-0.3000 F6000\nG1 " + end + b" F9000\nG1 Z4.0000 F6000\n"
    found = Oracle(subject).damage(subject.text.replace(last, back, 1))
    assert found.startswith("station 0 " + damage) if damage else found == ""


def test_a_corner_may_be_rounded_in_the_waste_only() -> None:
    subject = _named("router B, linuxcnc")
    oracle = Oracle(subject)
    before, found, lead = subject.text.rpartition(b"G1 Y95.5000")
    assert found
    assert oracle.damage(before + b"G64 P0.5 Q0.5\n" + found + lead) == ""
    line = before.rindex(b"G1 Y143.0000")
    rounded = before[:line] + b"G64 P0.5 Q0.5\n" + before[line:] + found + lead
    assert "rounded by 0.5 mm" in oracle.damage(rounded)


def test_a_drag_knife_must_not_cut_a_hole_again_in_a_released_part() -> None:
    subject = _named("drag knife, linuxcnc")
    begin = subject.text.index(b"G0 X144.0000 Y130.0000")
    hole = subject.text[begin : subject.text.index(b"G0 X172.8284")]
    before, found, rest = subject.text.rpartition(b"G0 X0.0000 Y0.0000")
    assert found
    text = before + hole + found + rest
    assert "works on a part after its outline" in Oracle(subject).damage(text)
    assert not subject.accepts(text)
