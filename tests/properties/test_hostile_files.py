"""Damaged files of every format give a valid drawing or a refusal with a hint.

Valid files are damaged line by line and number by number, and processed like the server does.
"""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from knifetip.errors import KnifetipError
from knifetip.formats.limits import REACH
from knifetip.model.interpretation import Interpretation
from knifetip.presentation.columns import unpack_columns
from knifetip.service.processes import tasks
from tests.support.examples import examples
from tests.support.writers import cf2_text, hpgl_text, lightburn_text, svg_text
from tests.support.writers import dxf_text as dxf

_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_NUMBERS = [
    b"nan",
    b"-inf",
    b"1e308",
    b"-1e308",
    b"1e-308",
    b"1e999",
    b"0",
    b"-1",
    b"1e7",
    b"99999",
]
_NUMBERS += [
    b"2147483648",
    b"-9223372036854775809",
    b"9" * 400,
    b"0." + b"0" * 400 + b"1",
    b"1e-12",
]
_NUMBERS += [b"", b"1,5", b"0x10", b"\xd9\xa3", b"1_000", b"--1", b"1e", b"."]


def carton() -> bytes:
    """Return a DXF file of a carton with blocks, arcs, polylines and texts."""
    return dxf.dxf(
        dxf.insert("PANEL", 0, 0, (41, 2.0), (50, 90.0)),
        dxf.insert("PANEL", 300, 0, (70, 2), (71, 2), (44, 200.0), (45, 150.0)),
        dxf.entity("CIRCLE", (8, "CUT"), (10, 30), (20, 30), (40, 8)),
        dxf.entity("POLYLINE", (8, "CREASE"), (66, 1), (70, 1)),
        dxf.entity("VERTEX", (8, "CREASE"), (10, 0), (20, 0), (42, 0.5)),
        dxf.entity("VERTEX", (8, "CREASE"), (10, 50), (20, 40)),
        dxf.entity("SEQEND"),
        dxf.entity("TEXT", (10, 1), (20, 2), (40, 3), (1, "250 mm")),
        blocks=(
            dxf.block(
                "PANEL",
                *(dxf.line(*ends, (8, "CUT")) for ends in ((0, 0, 100, 0), (100, 0, 100, 60))),
                dxf.entity("ARC", (8, "CUT"), (10, 50), (20, 60), (40, 50), (50, 0), (51, 180)),
                dxf.insert("FLAP", 10, 10),
            ),
            dxf.block("FLAP", dxf.line(0, 0, 0, 60, (8, "FOLD"), (6, "DASHED"))),
        ),
        layers=(dxf.layer("CUT", 1), dxf.layer("CREASE", 5, linetype="DASHED")),
    )


FILES = {
    "dxf": carton(),
    "svg": svg_text.carton(),
    "cf2": cf2_text.carton(),
    "plt": hpgl_text.carton(),
    "lightburn": lightburn_text.carton(),
}


@st.composite
def damage(draw: st.DrawFn, whole: bytes) -> bytes:
    """Draw a damaged version of the file ``whole``, with up to four changes to its lines or
    numbers.
    """
    lines = re.split(rb"(?<=[\n>])", whole)
    for _ in range(draw(st.integers(1, 4))):
        how = draw(
            st.sampled_from(["gone", "twice", "swapped", "often", "number", "number", "cut"])
        )
        at = draw(st.integers(0, len(lines) - 1))
        to = min(at + draw(st.integers(1, 6)), len(lines))
        if how == "gone":
            lines[at:to] = []
        elif how == "twice":
            lines[at:at] = lines[at:to]
        elif how == "swapped":
            lines[at], lines[to - 1] = lines[to - 1], lines[at]
        elif how == "often":
            lines[at:to] = lines[at:to] * draw(st.integers(2, 30))
        elif how == "number":
            found = list(_NUMBER.finditer(lines[at]))
            if found:
                low, high = draw(st.sampled_from(found)).span()
                lines[at] = lines[at][:low] + draw(st.sampled_from(_NUMBERS)) + lines[at][high:]
        else:
            lines[at] = lines[at][: draw(st.integers(0, len(lines[at])))]
        lines = lines or [b"\n"]
    return b"".join(lines)


def check_import(data: bytes, unit: str) -> bool:
    """Read, classify and clean a file like the server does; return whether it was not refused."""
    try:
        reading = tasks.read(lambda _stage, _share: None, data, Interpretation(unit))
    except KnifetipError as error:
        refused = error
    else:
        columns, _ = unpack_columns(reading.edges)
        assert (np.abs(columns["ends"]) <= 1.001 * REACH).all()
        assert (np.abs(columns["bulge"]) <= 1.0).all()
        if reading.summary["unit"]:
            tasks.cleaning_report(lambda _stage, _share: None, reading.edges)
        return True
    assert refused.hint
    assert refused.message.code != "reading.unexpected", refused.__cause__
    return False


@pytest.mark.parametrize("kind", FILES)
def test_damage_to_lines_and_numbers_ends_in_a_drawing_or_a_refusal(kind: str) -> None:
    read: list[bool] = []

    @examples(100, suppress_health_check=list(HealthCheck))
    @given(damage(FILES[kind]), st.sampled_from(["", "mm", "in"]))
    def imported(data: bytes, unit: str) -> None:
        read.append(check_import(data, unit))

    imported()
    # With too much or too little damage the test would prove nothing.
    assert {False, True} == set(read)
