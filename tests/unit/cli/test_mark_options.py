"""Marks of a printed sheet on the command line."""

from __future__ import annotations

import pytest

from knifetip.cli.job_options import MarkOptions
from knifetip.errors import PlanError


def test_marks_are_given_in_the_drawing_and_on_the_table() -> None:
    found = MarkOptions(mark=["5,5=71.2,44.9", " 280,5 = 345.8,-1e1 "], mark_scale="keep").record()
    assert found is not None
    assert found.marks == ((5.0, 5.0), (280.0, 5.0))
    assert found.measured == ((71.2, 44.9), (345.8, -10.0))
    assert (found.scale, found.limit) == ("keep", 0.5)
    planned = MarkOptions(mark=["5,5", "280,5"]).record()
    assert planned is not None
    assert planned.measured == ()
    assert MarkOptions().record() is None


@pytest.mark.parametrize(
    ("marks", "text"),
    [
        (["5"], "does not have the form X,Y or X,Y=X,Y"),
        (["5,5=1", "9,9"], "does not have the form X,Y or X,Y=X,Y"),
        (["5,5=1,1", "280,5"], "2 marks, and 1 of them were measured"),
        (["5,5", "6,5"], "only 1.0 mm away"),
        (["5,5"], "--mark"),
    ],
)
def test_wrong_marks_are_refused(marks: list[str], text: str) -> None:
    with pytest.raises(PlanError, match=text):
        MarkOptions(mark=marks).record()
