"""Drawings by other hands: the right unit, or a question; never a wrong one in silence."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.errors import KnifetipError
from knifetip.model.drawing import Drawing
from knifetip.units.evidence import judge

pytestmark = pytest.mark.corpus

#: Drawings whose unit is known: from the sizes in their names or in their words, or from their
#: makers.  "" in the third place: it is asked for.
KNOWN = [
    ("Obrary__Parametric-Papercraft/Interchange-Files/cube.dxf", "mm", "mm"),
    ("Obrary__Parametric-Papercraft/Interchange-Files/long.dxf", "mm", "mm"),
    ("generated__bikinon__RSC-FEFCO-02xx/f0200_B_300x200x150.dxf", "mm", "mm"),
    ("generated__bikinon__RSC-FEFCO-02xx/f0201_B_400x300x250.dxf", "mm", "mm"),
    ("generated__bikinon__RSC-FEFCO-02xx/f0203_B_350x250x100.dxf", "mm", "mm"),
    ("generated__minrogi__PLMPackLib-f421/F0421_400x300x100.dxf", "mm", "mm"),
    ("generated__kyholdings__diecut_generator/mailer_200x150x60_t3.dxf", "mm", "mm"),
    ("generated__kyholdings__diecut_generator/mailer_120x80x40_all_layers.dxf", "mm", "mm"),
    ("Jayanthan-Amalanathan__laser-cutting-and-engraving/box.dxf", "mm", "mm"),
    # Hardly a straight line in it, and as 190 mm it could as well be 1.9 m under a lying header.
    ("suhail-jr__Manual-pnP/cut.dxf", "mm", ""),
    # Through pstoedit: lengths are rounded to thousandths, and nothing states a unit.
    ("generated__eridur-de__mightyscape-inkpacking/box_rwlf.dxf", "mm", ""),
    ("generated__florianfesti__boxes/PaperBox_100x40x140.dxf", "mm", ""),
    ("generated__florianfesti__boxes/FlexBox.dxf", "mm", ""),
]


@pytest.mark.parametrize(("name", "truth", "decided"), KNOWN)
def test_known_drawing_is_read_in_its_unit_or_asks_with_it_first(
    corpus: Path, name: str, truth: str, decided: str
) -> None:
    drawing = pipeline.read((corpus / name).read_bytes())
    finding = judge(drawing)
    assert drawing.unit == decided
    assert decided in (truth, "")
    assert finding.ranking[0] == truth


def read(path: Path) -> Drawing | None:
    try:
        drawing = pipeline.read(path.read_bytes())
    except KnifetipError:
        return None
    return drawing if len(drawing) else None


def test_no_drawing_is_absurd_in_silence(corpus: Path) -> None:
    asked, against, stood = [], [], []
    for path in sorted(corpus.rglob("*.dxf")):
        drawing = read(path)
        if drawing is None:
            continue
        if not drawing.unit:
            asked.append(path.name)
            continue
        low_x, low_y, high_x, high_y = drawing.bounds
        longer = max(high_x - low_x, high_y - low_y)
        finding = judge(drawing)
        if drawing.stated and drawing.stated != drawing.unit:
            against.append(path.name)
            assert finding.warnings[0].startswith("The header states ")
            assert 2.0 <= longer <= 6000.0
        else:
            stood.append(path.name)
            # What needs no words is of the size of cartons, or has few edges and a header.
            assert 2.0 <= longer <= 6000.0, path.name
    # Most are no cartons: metre headers of a library, letters, floor plans.
    assert len(stood) >= 25
    assert len(asked) + len(against) + len(stood) >= 65


def test_metre_headers_of_a_library_do_not_make_cartons_of_hundred_metres(corpus: Path) -> None:
    folder = corpus / "mozman__ezdxf"
    stated = [read(path) for path in sorted(folder.rglob("*.dxf"))]
    metres = [drawing for drawing in stated if drawing is not None and drawing.stated == "m"]
    assert len(metres) >= 15
    for drawing in metres:
        assert drawing.unit != "m"
