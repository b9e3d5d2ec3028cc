"""classify, on drawings by other hands: which of them need no question, and which profile helps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from knifetip.classification.classify import classify, questions
from knifetip.dxf.read import read
from knifetip.library import load
from knifetip.model.dieline import LineType

pytestmark = pytest.mark.corpus

RSC = "generated__bikinon__RSC-FEFCO-02xx"
MAILER = "generated__kyholdings__diecut_generator"
OBRARY = "Obrary__Parametric-Papercraft/Interchange-Files"
RWLF = "generated__eridur-de__mightyscape-inkpacking/box_rwlf.dxf"


def types_on(path: Path, profile: str) -> dict[tuple[str, int], set[str]]:
    """The line types of each pair of layer and colour."""
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
def test_layers_that_say_what_they_are_need_no_question(
    corpus: Path, name: str, expected: dict[str, str]
):
    found = types_on(corpus / name, "default")
    assert {layer: kinds for (layer, _), kinds in found.items()} == {
        layer: {kind} for layer, kind in expected.items()
    }


@pytest.mark.parametrize(
    "name", ["f0200_B_300x200x150", "f0201_B_400x300x250", "f0203_B_350x250x100"]
)
def test_one_layer_called_design_is_told_apart_by_colour(corpus: Path, name: str):
    found = types_on(corpus / RSC / f"{name}.dxf", "default")
    assert found == {("Design", 1): {"cut"}, ("Design", 2): {"crease"}}


def test_layers_named_after_colours_are_asked_one_question_each(corpus: Path):
    drawing = read((corpus / RWLF).read_bytes())
    dieline = classify(drawing, load.profile("default"))
    put = questions(drawing, dieline)
    assert [question.layer for question in put] == ["C00-00-00-BLACK", "CFF-00-00"]
    rows = np.concatenate([question.edges for question in put])
    np.testing.assert_array_equal(np.sort(rows), np.arange(len(drawing)))
    assert put[0].choices[0] == "cut"


def test_layers_named_after_colours_are_right_under_their_profile(corpus: Path):
    found = types_on(corpus / RWLF, "red-crease-black-cut")
    assert {layer: kinds for (layer, _), kinds in found.items()} == {
        "C00-00-00-BLACK": {"cut"},
        "CFF-00-00": {"crease"},
    }


def test_labels_are_left_out_and_outside_paths_cut(corpus: Path):
    found = types_on(
        corpus / "Jayanthan-Amalanathan__laser-cutting-and-engraving/box.dxf", "default"
    )
    for (layer, _), kinds in found.items():
        assert kinds == ({"ignored"} if layer.endswith("_labelLayer") else {"cut"})
