from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np

from knifetip.messages import Message
from knifetip.model.verdict import Finding, Verdict
from knifetip.presentation.verdict import findings_json, verdict_summary


def refused() -> Verdict:
    areas = SimpleNamespace(area=np.array([2.0, 3.0]))
    return cast(
        "Verdict",
        SimpleNamespace(
            accepted=np.False_,
            tolerance=0.01,
            deviation=np.array([0.0, np.inf]),
            overcut=np.array([0.1, 0.0]),
            uncut=np.array([0.25, 0.5]),
            setback=np.array([1.0, 1.0]),
            areas=type("Areas", (), {"area": areas.area, "__len__": lambda _self: 2})(),
            seconds=4.0,
            findings=(
                Finding("uncut", Message("stored.text", text="a\0b", hint=""), np.nan, 1, 7),
            ),
        ),
    )


def test_a_summary_has_the_greatest_measures_and_the_sums_under_names_of_their_own() -> None:
    summary = verdict_summary(refused())
    assert (summary["uncut"], summary["uncut_total"], summary["setback_total"]) == (0.5, 0.75, 2.0)
    assert (summary["deviation"], summary["overcut"]) == (1e9, 0.1)
    assert (summary["unreached"], summary["unreached_places"]) == (5.0, 2)


def test_findings_have_the_handles_of_their_edges_and_finite_measures() -> None:
    (found,) = findings_json(refused(), ["A", "B"])
    assert (found["handle"], found["measure"]) == ("B", 1e9)
    assert (found["code"], found["arguments"]["text"]) == ("stored.text", "ab")
