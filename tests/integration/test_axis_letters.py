"""Machines whose heading has the letter A or B: programs, their verification, and settings."""

from __future__ import annotations

import re
import tomllib
from importlib import resources

import pytest

from knifetip import compensate, plan, process, sequence
from knifetip.errors import LibraryError
from knifetip.gateway.dry_program import dry_program
from knifetip.languages.registry import find_language
from knifetip.library import load
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.post.rs274.tool_table import tool_table
from knifetip.verification.verify import verify
from tests.support.shapes import closed, dieline, edges
from tests.support.verdicts import has_faults

BOARD = load.board("greyboard-2.0")
LINE = dieline(
    (LineType.V_GROOVE, edges(((110, 200), (290, 200)))),
    (LineType.CREASE, edges(((110, 150), (200, 150)), ((200, 150), (250, 150)))),
    (LineType.CUT, closed((100, 100), (300, 100), (300, 300), (100, 300))),
    bulge={2: 0.3, 3: 0.1},
)


def machine_file(name: str, letter: str, dialect: str = "") -> Machine:
    text = (resources.files("knifetip") / f"library/machines/{name}.toml").read_text("utf-8")
    fields = tomllib.loads(text)
    fields["axes"]["c"]["letter"] = letter
    if dialect:
        fields["dialect"] = dialect
    return load.parse_machine("own", fields)


def program(machine: Machine) -> bytes:
    toolpath = sequence([compensate(one) for one in plan(LINE, machine, BOARD)], machine)
    return process(toolpath, machine).text


@pytest.mark.parametrize("letter", ["A", "B"])
@pytest.mark.parametrize("dialect", ["grblhal", "linuxcnc"])
def test_the_letter_is_the_only_difference(dialect: str, letter: str) -> None:
    usual = program(machine_file("demo-table", "C", dialect))
    other = program(machine_file("demo-table", letter, dialect))
    assert re.sub(rb"\bC(?=-?\d)", letter.encode(), usual) == other != usual


@pytest.mark.parametrize("dialect", ["grblhal", "linuxcnc"])
def test_programs_are_read_with_the_letter_of_the_machine_only(dialect: str) -> None:
    usual, other = (machine_file("demo-table", letter, dialect) for letter in "CA")
    text = program(other)
    assert not has_faults(verify(text, LINE, (0.0, 0.0), other, BOARD))
    assert has_faults(verify(text, LINE, (0.0, 0.0), usual, BOARD))
    assert has_faults(verify(program(usual), LINE, (0.0, 0.0), other, BOARD))


def test_a_wrong_heading_under_another_letter_is_found() -> None:
    machine = machine_file("demo-table", "B", "grblhal")
    wrong = re.sub(rb"B90\.0000", b"B87.0000", program(machine))
    found = verify(wrong, LINE, (0.0, 0.0), machine, BOARD).findings
    assert any(finding.kind == "heading" for finding in found)


def test_dry_programs_keep_the_letter() -> None:
    machine = machine_file("demo-table", "A", "grblhal")
    dry = dry_program(program(machine), machine, 1.0)
    assert re.search(rb"G1 .*A-?\d", dry)
    assert not re.search(rb"C-?\d", dry)


def test_the_tool_table_and_the_settings_have_the_letter() -> None:
    machine = machine_file("demo-table", "A", "linuxcnc")
    assert " A+0.0000" in tool_table(machine) or " A0" in tool_table(machine)
    lines = find_language("linuxcnc").load_part("setting_lines")(machine)
    assert "[AXIS_A]" in lines
    assert "[AXIS_C]" not in lines
    lines = find_language("grblhal").load_part("setting_lines")(machine)
    assert "$113=216000" in lines


@pytest.mark.parametrize("name", ["flat-cutter-hpgl", "v-groove-table"])
def test_a_language_without_the_letter_refuses_the_file(name: str) -> None:
    with pytest.raises(LibraryError, match=r"rotary axis A.*axes are C"):
        machine_file(name, "A")


@pytest.mark.parametrize(
    ("name", "kind"), [("fine-router-table", "cutter"), ("laser-table", "laser")]
)
def test_cutters_and_lasers_need_no_axis_for_a_heading(name: str, kind: str) -> None:
    text = (resources.files("knifetip") / f"library/machines/{name}.toml").read_text("utf-8")
    fields = tomllib.loads(text)
    del fields["axes"]["c"]
    fields["station"] = [one for one in fields["station"] if one["tool"]["kind"] == kind]
    machine = load.parse_machine("own", fields)
    assert list(machine.axes) == ["X", "Y", "Z"]
    line = dieline((LineType.CUT, closed((100, 100), (300, 100), (300, 300), (100, 300))))
    toolpath = sequence([compensate(one) for one in plan(line, machine, BOARD)], machine)
    made = process(toolpath, machine).text
    assert not re.search(rb"[ABC]-?\d+\.\d", made)
    assert verify(made, line, (0.0, 0.0), machine, BOARD).findings == ()
    # A heading that the machine does not have is a fault.
    wrong = made.replace(b"G0 X", b"G0 C90.0000 X", 1)
    assert has_faults(verify(wrong, line, (0.0, 0.0), machine, BOARD))
    settings = find_language(machine.dialect).load_part("setting_lines")(machine)
    assert not [one for one in settings if one.startswith(("$103", "$376", "[AXIS_C]"))]


def test_carriages_need_different_letters() -> None:
    with pytest.raises(LibraryError, match="letters A, V, A; each letter"):
        machine_file("two-carriage-table", "A")
    first, second = machine_file("two-carriage-table", "B").carriages
    assert (first.letters, second.letters) == ("XYZB", "XVZA")
