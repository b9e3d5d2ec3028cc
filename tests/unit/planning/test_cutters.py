"""A machine uses the thickest of its router bits that leaves nothing uncut."""

from __future__ import annotations

from dataclasses import replace

import pytest

from knifetip import pipeline
from knifetip.errors import PlanError
from knifetip.geometry.columns import F64
from knifetip.library import load
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import Cutter
from knifetip.pipeline import Compiled
from tests.support.drawings import drawing
from tests.support.shapes import closed, dieline, edges

OUTLINE = closed((0, 0), (300, 0), (300, 200), (0, 200))


def slot(width: float) -> F64:
    return closed((100, 100), (180, 100), (180, 100 + width), (100, 100 + width))


def compiled(machine: str | Machine, *cuts: F64) -> Compiled:
    lines = dieline(*((LineType.CUT, cut) for cut in (OUTLINE, *cuts)))
    used = load.machine(machine) if isinstance(machine, str) else machine
    drawn = drawing(lines.ends, [("0", 7, "CONTINUOUS")] * len(lines))
    return pipeline.compile(drawn, lines, used, load.board("greyboard-2.0"))


def diameters(made: Compiled, machine: str) -> set[float]:
    """Return the diameters of the cutters that a program uses."""
    stations = [load.machine(machine).station(int(number)) for number in set(made.toolpath.tool)]
    return {station.tool.diameter for station in stations}


def cutter_notes(made: Compiled) -> list[Message]:
    messages = [finding.message for finding in made.verdict.findings]
    return [message for message in messages if message.code.startswith("cutter.")]


@pytest.mark.parametrize(("width", "diameter"), [(8.0, 3.0), (3.1, 3.0), (2.5, 2.0), (1.8, 1.5)])
def test_the_thickest_cutter_that_serves_makes_the_cuts(width: float, diameter: float) -> None:
    made = compiled("fine-router-table", slot(width))
    assert made.verdict.accepted
    assert diameters(made, "fine-router-table") == {diameter}
    chosen = [note.code for note in cutter_notes(made)]
    assert chosen == ([] if diameter == 3.0 else ["cutter.thinner-chosen"])


def test_the_thinnest_cutter_makes_slits_which_every_cutter_makes_too_wide() -> None:
    made = compiled("fine-router-table", edges(((50, 50), (150, 50))))
    assert diameters(made, "fine-router-table") == {1.5}
    assert [note.code for note in cutter_notes(made)] == ["cutter.thinner-chosen"]


def test_the_hint_names_the_thickest_cutter_of_the_library_that_serves() -> None:
    made = compiled("router-table", slot(2.5))
    assert not made.verdict.accepted
    [note] = cutter_notes(made)
    assert note.code == "cutter.thinner-needed"
    assert note.arguments["diameter"] == 2.0
    assert note.arguments["count"] == note.arguments["total"] == 4
    [used] = [tool for title, tool in load.cutters().items() if title == note.arguments["title"]]
    # Who follows the hint has an accepted program.
    machine = load.machine("router-table")
    changed = [
        replace(station, tool=used) if isinstance(station.tool, Cutter) else station
        for station in machine.stations
    ]
    assert compiled(replace(machine, stations=tuple(changed)), slot(2.5)).verdict.accepted


def test_no_hint_is_given_if_no_cutter_serves() -> None:
    made = compiled("router-table", slot(1.0))
    assert not made.verdict.accepted
    assert cutter_notes(made) == []


def test_slits_have_one_hint_for_all_of_them() -> None:
    made = compiled("router-table", edges(((50, 50), (150, 50)), ((50, 80), (150, 80))))
    [note] = cutter_notes(made)
    assert note.code == "cutter.narrower-slits"
    assert note.arguments["count"] == 2
    assert (note.arguments["width"], note.arguments["diameter"]) == (6.0, 1.5)


def test_a_job_that_no_cutter_makes_is_refused_with_the_reason_of_the_thinnest() -> None:
    crossing = closed((250, 150), (350, 150), (350, 250), (250, 250))
    with pytest.raises(PlanError) as caught:
        compiled("fine-router-table", crossing)
    assert "crosses" in str(caught.value)


def test_a_knife_has_no_notes_about_cutters() -> None:
    assert cutter_notes(compiled("demo-table", slot(1.0))) == []
