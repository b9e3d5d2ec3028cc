"""Lines of programs are dropped, repeated, swapped and changed: what moves the product is refused.

An accepted mutant must leave the product unchanged within 0.01 mm and must be safe on a machine
that a cancelled job has left with a station lowered; ``HARMLESS`` lists the exceptions with their
reasons.
"""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from tests.support.examples import drawn
from tests.support.programs.digit_mutation import TOLERANCE
from tests.support.programs.engines import ENGINES
from tests.support.programs.line_mutation import displacement, hazard, mutants
from tests.support.verdicts import has_faults

#: Number of mutants of each engine that are verified, chosen by the seed.
COUNT, SEED = drawn(110), 3
#: (engine, kind): changes in the waste only, where the knife may stop at the contour's end.
HARMLESS = {("knife with leads", "line dropped"), ("knife with leads", "lines swapped")}


@pytest.mark.parametrize("name", ENGINES)
def test_a_changed_line_is_refused_or_leaves_the_product_as_it_is(name: str) -> None:
    engine = ENGINES[name]
    right = engine.verdict_of(engine.text)
    assert not has_faults(right), right.findings[:3]
    every = list(mutants(engine.text))
    refused = 0
    let_pass: Counter[str] = Counter()
    missed: list[tuple[str, int, float | str, str]] = []
    for k in np.random.default_rng(SEED).choice(len(every), COUNT, replace=False):
        kind, row, mutant = every[k]
        if has_faults(engine.verdict_of(mutant)):
            refused += 1
            continue
        let_pass[kind] += 1
        far = displacement(engine.text, mutant, engine.machine, engine.board, engine.line)
        if far > TOLERANCE + 1e-6 and (name, kind) not in HARMLESS:
            missed.append((kind, row + 1, far, mutant.splitlines()[row]))
        if harm := hazard(mutant, engine.machine):
            missed.append((kind, row + 1, harm, mutant.splitlines()[row]))
    print(name, f"{refused}/{COUNT} refused, harmless:", dict(let_pass))
    assert not missed
    # More than half of all changes matter.
    assert refused > 0.5 * COUNT


#: Mutants that verifiers have accepted by mistake: full turns of C, missing releases and lifts.
DECEIVING = (
    "C turned by 360",
    "C turned by -360",
    "line dropped",
    "lifted after the next is lowered",
)


@pytest.mark.parametrize("name", ENGINES)
def test_every_full_turn_in_the_board_and_every_missing_release_or_lift_is_refused(
    name: str,
) -> None:
    engine = ENGINES[name]
    assert hazard(engine.text, engine.machine) == ""
    dangerous = []
    for kind, row, mutant in mutants(engine.text):
        if kind not in DECEIVING:
            continue
        line = engine.text.splitlines()[row]
        turn = kind.startswith("C") and not line.startswith(b"G0") and b"C" in line
        if turn or (not kind.startswith("C") and hazard(mutant, engine.machine)):
            dangerous.append((kind, row, mutant))
    assert len(dangerous) > 5
    chosen = np.random.default_rng(SEED).choice(len(dangerous), min(20, len(dangerous)), False)
    missed = [
        dangerous[k][:2] for k in chosen if not has_faults(engine.verdict_of(dangerous[k][2]))
    ]
    assert not missed
