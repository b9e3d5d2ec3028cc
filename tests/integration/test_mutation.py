"""Random changes of one digit in real programs: every change that moves the working tip is
refused.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.library import load
from tests.support.examples import drawn
from tests.support.programs.digit_mutation import changed_line, count_refusals
from tests.support.truth.named import NAMED, SAMPLES, Named

#: Number of changed digits.
COUNT = drawn(150)
MACHINE = load.machine("demo-table")


def every_moving_mutant_is_refused(named: Named, corpus: Path | None, dialect: str) -> None:
    drawing, dieline, board = named.classified(corpus)
    made = pipeline.compile(drawing, dieline, MACHINE, board, dialect=dialect)

    def refused(text: bytes) -> bool:
        return not pipeline.verify(text, dieline, made.placement, MACHINE, board).accepted

    assert not refused(made.program.text)
    everything, caught, missed = count_refusals(
        made.program.text, MACHINE, board, refused, count=COUNT, seed=1
    )
    print(named, dialect, {kind: f"{caught[kind]}/{everything[kind]}" for kind in everything})
    assert everything["moved"] > 20 * COUNT // 150
    for kind in ("moved", "line", "code", "output"):
        let_pass = [
            changed_line(made.program.text, place, text) for k, place, text in missed if k == kind
        ]
        assert caught[kind] == everything[kind], let_pass


@pytest.mark.parametrize("dialect", ["linuxcnc", "grblhal"])
@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_mutants_of_our_samples_are_refused(named: Named, dialect: str) -> None:
    every_moving_mutant_is_refused(named, None, dialect)


@pytest.mark.corpus
@pytest.mark.parametrize("named", NAMED, ids=str)
def test_mutants_of_drawings_by_other_authors_are_refused(named: Named, corpus: Path) -> None:
    every_moving_mutant_is_refused(named, corpus, "linuxcnc")
