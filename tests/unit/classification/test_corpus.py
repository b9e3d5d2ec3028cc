"""Classification of public drawings: which need no question, and which profile helps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.classification.classify import classify
from knifetip.classification.questions import list_questions
from knifetip.cleaning.clean import clean
from knifetip.dxf.read import read
from knifetip.library import load
from knifetip.model.dieline import LineType
from tests.support.truth.known_types import KNOWN, Known, classification_fractions, without_names

pytestmark = pytest.mark.corpus

RSC = "generated__bikinon__RSC-FEFCO-02xx"
MAILER = "generated__kyholdings__diecut_generator"
OBRARY = "Obrary__Parametric-Papercraft/Interchange-Files"
RWLF = "generated__eridur-de__mightyscape-inkpacking/box_rwlf.dxf"


def types_on(path: Path, profile: str) -> dict[tuple[str, int], set[str]]:
    """Return the line types of the edges of each (layer, colour) in a file."""
    drawing = read(path.read_bytes())
    dieline = classify(drawing, load.profile(profile))
    assert len(dieline) == len(drawing) > 0
    found: dict[tuple[str, int], set[str]] = {}
    for layer, colour, kind in zip(drawing.layer, drawing.colour, dieline.line_type, strict=True):
        pair = (drawing.layers[layer], int(colour))
        found.setdefault(pair, set()).add(LineType(kind).word)
    return found


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        (f"{OBRARY}/cube.dxf", {"CUTS": "cut", "FOLDS": "crease"}),
        (f"{OBRARY}/long.dxf", {"CUTS": "cut", "FOLDS": "crease"}),
        (
            f"{MAILER}/mailer_120x80x40_all_layers.dxf",
            {"CUT": "cut", "CREASE": "crease", "HALFCUT": "half-cut", "DIMENSION": "ignored"},
        ),
        (f"{MAILER}/mailer_200x150x60_t3.dxf", {"CUT": "cut", "CREASE": "crease"}),
        (
            "generated__minrogi__PLMPackLib-f421/F0421_400x300x100.dxf",
            {"LT_CUT": "cut", "LT_FOLD": "crease"},
        ),
    ],
)
def test_layers_with_meaningful_names_need_no_question(
    corpus: Path, name: str, expected: dict[str, str]
) -> None:
    found = types_on(corpus / name, "default")
    assert {layer: kinds for (layer, _), kinds in found.items()} == {
        layer: {kind} for layer, kind in expected.items()
    }


@pytest.mark.parametrize("name", ["f0201_B_400x300x250", "f0203_B_350x250x100"])
def test_lines_on_one_layer_called_design_are_distinguished_by_colour(
    corpus: Path, name: str
) -> None:
    found = types_on(corpus / RSC / f"{name}.dxf", "default")
    assert found == {("Design", 1): {"cut"}, ("Design", 2): {"crease"}}


def test_a_crease_on_a_cut_is_not_asked_about(corpus: Path) -> None:
    """FEFCO 0200 has flaps on one side only; on the other side its creases lie on the outline."""
    drawing = read((corpus / RSC / "f0200_B_300x200x150.dxf").read_bytes())
    dieline = classify(drawing, load.profile("default"), load.conventions())
    assert list_questions(drawing, dieline) == []
    on_a_cut = [rule.code == "classification.on-cut" for rule in dieline.rules]
    rows = np.flatnonzero(np.array(on_a_cut)[dieline.rule])
    assert drawing.lengths[rows].sum() == pytest.approx(988.0)
    cleaned = clean(dieline)
    assert cleaned.merged[rows] == pytest.approx(drawing.lengths[rows])
    assert cleaned.merged.sum() == pytest.approx(988.0)


def test_layers_named_after_colours_need_no_question(corpus: Path) -> None:
    """One panel is open, so three creases bound the blank; their panel would fall off as cuts."""
    drawing = read((corpus / RWLF).read_bytes())
    truth = ["cut" if "BLACK" in drawing.layers[row] else "crease" for row in drawing.layer]
    for profile in ("default", "red-crease-black-cut"):
        dieline = classify(drawing, load.profile(profile), load.conventions())
        put = list_questions(drawing, dieline)
        asked = {row for question in put for row in question.edges}
        for row, kind in enumerate(dieline.line_type):
            assert (row in asked) == (kind == LineType.UNCLASSIFIED)
            assert row in asked or LineType(kind).word == truth[row]
        assert asked == set()


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: Path(known.path).name)
def test_known_drawings_are_right_or_asked_and_never_silently_wrong(
    corpus: Path, known: Known
) -> None:
    drawing = pipeline.read((corpus / known.path).read_bytes())
    truth = known.truth(drawing)
    for seen in (drawing, without_names(drawing)):
        said = classify(seen, load.profile("default"), load.conventions()).line_type
        _, _, wrong = classification_fractions(truth, said, np.ones(len(said)))
        assert wrong == 0.0
    # With layer names, nearly all edges are right without a question.
    said = classify(drawing, load.profile("default"), load.conventions()).line_type
    right, _, _ = classification_fractions(truth, said, drawing.lengths)
    assert right > 0.5


def test_labels_are_left_out_and_outside_paths_cut(corpus: Path) -> None:
    found = types_on(
        corpus / "Jayanthan-Amalanathan__laser-cutting-and-engraving/box.dxf", "default"
    )
    for (layer, _), kinds in found.items():
        assert kinds == ({"ignored"} if layer.endswith("_labelLayer") else {"cut"})
