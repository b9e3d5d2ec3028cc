"""The import report of a DXF file agrees with the edges, and damage changes no edge silently."""

from __future__ import annotations

from collections import Counter

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from knifetip.dxf.read import read
from knifetip.dxf.value_types import DECIMAL, INTEGER, TYPE
from knifetip.errors import KnifetipError, NotADrawing
from knifetip.model.drawing import Drawing, ImportOutcome
from tests.support.examples import examples
from tests.support.writers.random_dxf import drawings

DAMAGED = ("1,5", "1.2.3", "-1.#IND", "12O", "", "nan", "1_0")

slow = examples(200, suppress_health_check=list(HealthCheck))


def read_or_error(data: bytes) -> Drawing | KnifetipError:
    try:
        return read(data)
    except KnifetipError as error:
        return error


@slow
@given(drawings())
def test_kept_rows_have_edges_and_all_other_rows_have_none(data: bytes) -> None:
    drawing = read_or_error(data)
    if isinstance(drawing, KnifetipError):
        return
    report = drawing.import_report
    edges = np.bincount(drawing.entity, minlength=len(report))
    for row in range(len(report)):
        told = report.handle[row], report.kind[row], str(report.reason[row])
        if report.outcome[row] != ImportOutcome.KEPT:
            assert edges[row] == 0, told
            assert report.length[row] == 0.0, told
        elif report.kind[row] != "INSERT":
            assert edges[row] > 0, told
            assert report.length[row] > 0.0, told


def numbers_of(data: bytes) -> list[int]:
    """Return the indices of the lines with numbers in the sections BLOCKS and ENTITIES."""
    lines = data.split(b"\n")
    start = data[: data.index(b"BLOCKS")].count(b"\n")
    found = []
    for index in range(start + 1, len(lines) - 1, 2):
        code = int(lines[index])
        if TYPE[code] in (DECIMAL, INTEGER) and code < 1000:
            found.append(index + 1)
    return found


def test_a_damaged_number_is_refused_or_changes_no_edge() -> None:
    tally: Counter[str] = Counter()

    # All of them also in `make test`: few damaged numbers are read.
    @settings(max_examples=200, suppress_health_check=list(HealthCheck))
    @given(drawings(), st.data())
    def unchanged(data: bytes, choice: st.DataObject) -> None:
        intact = read_or_error(data)
        numbers = numbers_of(data)
        if isinstance(intact, KnifetipError) or not numbers:
            return
        lines = data.split(b"\n")
        at = choice.draw(st.sampled_from(numbers))
        lines[at] = choice.draw(st.sampled_from(DAMAGED)).encode()
        damaged = read_or_error(b"\n".join(lines))
        if isinstance(damaged, KnifetipError):
            assert isinstance(damaged, NotADrawing)
            assert damaged.message.code == "dxf.not-a-number", str(damaged)
            tally["refused"] += 1
        else:
            assert damaged.ends.tobytes() == intact.ends.tobytes()
            assert damaged.bulge.tobytes() == intact.bulge.tobytes()
            tally["read"] += 1

    unchanged()
    assert tally["refused"] > 50, tally
    assert tally["read"] > 0, tally
