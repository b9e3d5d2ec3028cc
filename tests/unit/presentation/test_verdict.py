from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from knifetip.messages import Message
from knifetip.model.program_figures import ProgramFigures
from knifetip.model.verdict import Finding, Severity, UnreachedAreas, Verdict
from knifetip.presentation.verdict import (
    areas_json,
    finding_from_json,
    findings_json,
    refused_edges,
    unpack_areas,
    verdict_summary,
)


def refused() -> Verdict:
    areas = SimpleNamespace(area=np.array([2.0, 3.0]))
    return cast(
        "Verdict",
        SimpleNamespace(
            accepted=np.False_,
            tolerance=0.01,
            deviation=np.array([0.0, np.inf]),
            path_deviation=np.array([0.0, 0.5]),
            blending=np.array([0.005, 0.0]),
            fit_error=np.array([0.004, 0.003]),
            overcut=np.array([0.1, 0.0]),
            uncut=np.array([0.25, 0.5]),
            setback=np.array([1.0, 1.0]),
            unreached=np.array([3.0, 4.0]),
            unreached_distance=np.array([0.5, 1.5]),
            slit_length=np.array([0.0, 20.0]),
            areas=type("Areas", (), {"area": areas.area, "__len__": lambda _self: 2})(),
            seconds=4.0,
            program=ProgramFigures(lowest_travel=3.0),
            findings=(
                Finding("uncut", Message("stored.text", text="a\0b", hint=""), np.nan, 1, 7),
            ),
        ),
    )


def test_a_summary_has_the_greatest_measures_and_the_sums_under_names_of_their_own() -> None:
    summary = verdict_summary(refused())
    assert (summary["uncut"], summary["uncut_total"], summary["setback_total"]) == (0.5, 0.75, 2.0)
    assert (summary["deviation"], summary["overcut"]) == (1e9, 0.1)
    parts = [summary[name] for name in ("path_deviation", "blending", "fit_error")]
    assert parts == [0.5, 0.005, 0.004]
    assert (summary["unreached"], summary["unreached_places"]) == (5.0, 2)
    assert (summary["unreached_length"], summary["unreached_distance"]) == (7.0, 1.5)
    assert (summary["slit_length"], summary["slit_places"]) == (20.0, 1)
    assert summary["lowest_travel"] == 3.0


def test_findings_have_the_handles_of_their_edges_and_finite_measures() -> None:
    (found,) = findings_json(refused(), ["A", "B"])
    assert (found["handle"], found["measure"]) == ("B", 1e9)
    assert (found["code"], found["arguments"]["text"]) == ("stored.text", "ab")
    assert (found["severity"], found["refuses"]) == ("fault", True)
    assert (found["edge"], found["edges"]) == (1, [1])
    assert finding_from_json(found).all_edges == (1,)


def test_a_program_is_refused_because_of_all_edges_that_are_made_as_one() -> None:
    message = Message("verify.unclassified")
    findings = [
        Finding("uncut", message, 4.0, edge=7, edges=(7, 3, 8)),
        Finding("uncut", message, 4.0, edge=1, severity=Severity.NOTE),
        Finding("feed", message, 1.0),
    ]
    verdict = cast("Verdict", SimpleNamespace(findings=findings))
    rows = findings_json(verdict, [f"{row:X}" for row in range(9)])
    assert refused_edges(rows) == [3, 7, 8]
    # Older versions stored the edge only.
    assert refused_edges([{"refuses": True, "edge": 5}, {"refuses": True, "edge": -1}]) == [5]


def test_areas_have_centre_and_outline_and_are_sorted_by_size() -> None:
    square = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
    half_disc = np.array([[10.0, 0.0], [14.0, 0.0]])
    ends = np.concatenate(
        [np.stack([ring, np.roll(ring, -1, axis=0)], axis=1) for ring in (square, half_disc)]
    )
    areas = UnreachedAreas(
        ends, np.array([0.0] * 5 + [1.0]), np.array([0, 4, 6]), np.array([4.0, 6.28])
    )
    first, second = areas_json(areas)
    assert (first["area"], first["x"], first["y"]) == (6.28, 12.0, 0.0)
    assert first["outline"] == [[[10.0, 0.0], [14.0, 0.0], 0.0], [[14.0, 0.0], [10.0, 0.0], 1.0]]
    assert (second["area"], second["x"], second["y"], len(second["outline"])) == (4.0, 1.0, 1.0, 4)
    columns: dict[str, NDArray[Any]] = {
        "area_ends": areas.ends,
        "area_bulge": areas.bulge,
        "area_first": areas.first,
        "area_size": areas.area,
    }
    assert areas_json(unpack_areas(columns)) == [first, second]
    assert areas_json(unpack_areas({})) == []
