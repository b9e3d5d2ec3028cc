"""warming: every kernel run once, so that no user waits for one to be compiled.

    samples, and drawings as nobody wishes for -> machine code, kept beside the source

The first call takes minutes, the next a few seconds.  What the samples have nothing of is drawn
here: edges that lie on each other, letters, a bleed, entities that only ezdxf can read.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from contextlib import suppress
from typing import Final

import numpy as np

from knifetip.dxf.samples import samples
from knifetip.errors import CompensationError
from knifetip.geometry.offset import equidistant
from knifetip.geometry.path import Paths
from knifetip.library import load
from knifetip.pipeline import classify, clean, compile, read

_Line = tuple[float, float, float, float]

#: A blank of two panels, its bleed, and three letters.
_NAMELESS: Final[tuple[_Line, ...]] = (
    *((0, 0, 200, 0), (200, 0, 200, 70), (200, 70, 180, 90), (180, 90, 0, 90), (0, 90, 0, 0)),
    *((100, 0, 100, 90), (-3, -3, 203, -3), (203, -3, 203, 71), (203, 71, 181, 93)),
    *((181, 93, -3, 93), (-3, 93, -3, -3)),
    *((20, 20, 20, 26), (20, 20, 24, 20), (28, 20, 28, 26), (32, 26, 36, 26), (34, 20, 34, 26)),
)
#: A lap, a gap and a speck.
_UNTIDY: Final[tuple[_Line, ...]] = (
    *((0, 0, 100, 0), (50, 0, 150, 0), (150.02, 0, 150.02, 50), (70, 70, 70.01, 70)),
)
#: A hole in a blank whose outline does not quite close.
_NESTED: Final[tuple[_Line, ...]] = (
    *((0, 0, 100, 0), (100, 0, 100, 80), (100, 80, 0, 80), (0, 80, 0, 0.5)),
    *((30, 30, 60, 30), (60, 30, 60, 50), (60, 50, 30, 50), (30, 50, 30, 30)),
)
#: The walls of a notch cross by a tenth of a micrometre on their way down: it is told where.
_TORN: Final = (
    *((0, 0), (100, 0), (100, 60), (50.0001, 60), (49.9999, 30), (50.0001, 30)),
    *((49.9999, 60), (0, 60)),
)
#: A polyline and arcs above the ground or seen from below, and a block placed as its mirror image.
_ODD: Final = """
0 BLOCK 2 A 10 0 20 0 0 ARC 8 0 10 0 20 0 40 5 50 0 51 90 0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES
0 LWPOLYLINE 100 AcDbEntity 8 0 100 AcDbPolyline 90 3 70 1 38 5 10 0 20 0 42 0.5 10 9 20 0 10 9 20 9
0 ARC 8 0 10 0 20 0 30 5 40 9 50 0 51 90 210 0 220 0 230 -1
0 INSERT 8 0 2 A 10 50 20 50 41 -1 50 30
0 INSERT 8 0 2 A 10 90 20 50 70 2 71 2 44 20 45 20
0 CIRCLE 8 0 10 0 20 0 30 5 40 9 210 0 220 0 230 -1
"""


def warm() -> None:
    """Run every compiled kernel that a request may need."""
    offsets()
    drawings()
    _made("rigid-box-blank.dxf", "greyboard-2.0", "router-table")


def offsets() -> None:
    """Run the kernels of equidistants, which are as much work to compile as all others."""
    contour = np.array(_TORN, np.float64)
    one = np.array([0, len(contour)])
    with suppress(CompensationError):
        equidistant(Paths(contour, np.roll(contour, -1, axis=0), np.zeros(one[1]), one), 3.0, 1)


def drawings() -> None:
    """Run the kernels that read drawings, tell their edges, clean them and make jobs of them."""
    # Path data has a kernel of its own.
    read(b'<svg width="9mm" viewBox="0 0 9 9"><path stroke="red" d="M0 0h9"/></svg>')
    odd = _dxf("BLOCKS", " ".join(_ODD.split()))
    read(odd)
    # What is written with line ends of its own is read by ezdxf.
    read(odd.replace(b"\n", b"\r"))
    rules = load.profile("default")
    classify(read(_dxf("ENTITIES", _lines(_NAMELESS)), "mm"), rules)
    clean(classify(read(_dxf("ENTITIES", _lines(_UNTIDY, "CUT")), "mm"), rules))
    nested = read(_dxf("ENTITIES", _lines(_NESTED, "CUT")), "mm")
    compile(nested, classify(nested, rules), load.machine("demo-table"), load.board("fbb-0.4"))
    _made("tuck-end-carton.dxf", "fbb-0.4", "demo-table")
    _made("rigid-box-blank.dxf", "greyboard-2.0", "demo-table")


def _made(sample: str, board: str, machine: str) -> None:
    drawing = read(samples()[sample])
    line = classify(drawing, load.profile("default"))
    compile(drawing, line, load.machine(machine), load.board(board))


def _lines(lines: Iterable[_Line], layer: str = "0") -> str:
    return " ".join(f"0 LINE 8 {layer} 10 {x0} 20 {y0} 11 {x1} 21 {y1}" for x0, y0, x1, y1 in lines)


def _dxf(section: str, words: str) -> bytes:
    head = f"0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 0 ENDSEC 0 SECTION 2 {section}"
    return "\n".join(f"{head} {words} 0 ENDSEC 0 EOF ".split(" ")).encode()


if __name__ == "__main__":
    {"offsets": offsets, "drawings": drawings, "warm": warm}[sys.argv[1]]()
