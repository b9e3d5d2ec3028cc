"""Units of drawings from other programs: right, or asked for; never wrong without a warning."""

from __future__ import annotations

from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.errors import KnifetipError
from knifetip.model.drawing import Drawing
from knifetip.units.evidence import find_unit

pytestmark = pytest.mark.corpus

#: File, true unit (from sizes in names or texts, or from the author), and the unit that is chosen
#: ("" if the user is asked).
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
    # It has few straight lines, but the header of Inkscape, which writes the unit that it uses.
    ("suhail-jr__Manual-pnP/cut.dxf", "mm", "mm"),
    # No unit is stated, and lengths are rounded to thousandths; the page is that of pstoedit in mm.
    ("generated__eridur-de__mightyscape-inkpacking/box_rwlf.dxf", "mm", "mm"),
    # They state no unit, but curls of 0.15 mm at their corners show that they are for a laser.
    ("generated__florianfesti__boxes/PaperBox_100x40x140.dxf", "mm", "mm"),
    ("generated__florianfesti__boxes/FlexBox.dxf", "mm", "mm"),
]


@pytest.mark.parametrize(("name", "truth", "decided"), KNOWN)
def test_known_drawing_is_read_in_its_unit_or_asks_with_it_first(
    corpus: Path, name: str, truth: str, decided: str
) -> None:
    drawing = pipeline.read((corpus / name).read_bytes())
    finding = find_unit(drawing)
    assert drawing.unit == decided
    assert decided in (truth, "")
    assert finding.ranking[0] == truth


def read(path: Path) -> Drawing | None:
    try:
        drawing = pipeline.read(path.read_bytes())
    except KnifetipError:
        return None
    return drawing if len(drawing) else None


def test_absurd_sizes_are_asked_or_warned_of(corpus: Path) -> None:
    asked, overruled, kept = [], [], []
    for path in sorted(corpus.rglob("*.dxf")):
        drawing = read(path)
        if drawing is None:
            continue
        if not drawing.unit:
            asked.append(path.name)
            continue
        low_x, low_y, high_x, high_y = drawing.bounds
        longer = max(high_x - low_x, high_y - low_y)
        finding = find_unit(drawing)
        if drawing.stated and drawing.stated != drawing.unit:
            overruled.append(path.name)
            assert finding.warnings[0].code == "unit.read-against-header"
            assert 2.0 <= longer <= 6000.0
        else:
            kept.append(path.name)
            # A drawing without a warning has the size of a carton, or few edges and a header.
            assert 2.0 <= longer <= 6000.0, path.name
    # Most files are not cartons: metre headers of a library, letters, floor plans.
    assert len(kept) >= 25
    assert len(asked) + len(overruled) + len(kept) >= 65


def test_metre_headers_of_a_library_do_not_make_cartons_of_hundred_metres(corpus: Path) -> None:
    folder = corpus / "mozman__ezdxf"
    stated = [read(path) for path in sorted(folder.rglob("*.dxf"))]
    metres = [drawing for drawing in stated if drawing is not None and drawing.stated == "m"]
    assert len(metres) >= 15
    for drawing in metres:
        assert drawing.unit != "m"
