"""Cartons of the samples and of the corpus: each blank gives a tree, and none an error."""

from __future__ import annotations

import pytest

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.folding.findings import find_faults
from knifetip.folding.fold import fold_tree
from knifetip.folding.records import FoldOptions, FoldTree
from knifetip.library import load
from tests.conftest import CORPUS


def folded(content: bytes, board: str = "c-flute") -> FoldTree:
    dieline = pipeline.classify(pipeline.read(content), load.profile("default"))
    return fold_tree(pipeline.clean(dieline).dieline, load.board(board), FoldOptions())


@pytest.mark.parametrize(
    ("name", "board", "panels"),
    [
        ("tuck-end-carton.dxf", "fbb-0.4", 13),
        ("corrugated-tray.dxf", "b-flute", 13),
        ("rigid-box-blank.dxf", "greyboard-2.0", 5),
    ],
)
def test_a_sample_folds_without_a_fault(name: str, board: str, panels: int) -> None:
    tree = folded(samples()[name], board)
    assert (len(tree.panels), len(tree.order), len(tree.folds)) == (panels, panels - 1, panels - 1)
    assert find_faults(tree) == []


@pytest.mark.skipif(not CORPUS.is_dir(), reason="the corpus is not here")
def test_cartons_of_the_corpus_give_trees_without_cycles() -> None:
    cartons = [
        *sorted(CORPUS.glob("generated__bikinon__RSC-FEFCO-02xx/*.dxf")),
        *sorted(CORPUS.glob("generated__kyholdings__diecut_generator/*.dxf")),
        *sorted(CORPUS.glob("Obrary__Parametric-Papercraft/**/*.dxf")),
    ]
    trees = {path.stem: folded(path.read_bytes()) for path in cartons}
    panels = {name: len(tree.panels) for name, tree in trees.items()}
    assert panels == {
        "f0200_B_300x200x150": 9,
        "f0201_B_400x300x250": 13,
        "f0203_B_350x250x100": 13,
        "mailer_120x80x40_all_layers": 23,
        "mailer_200x150x60_t3": 23,
        "cube": 19,
        "long": 19,
    }
    for tree in trees.values():
        assert not any(fold.closes for fold in tree.folds)
        assert all(fold.hinge.straight for fold in tree.folds)
        assert len(tree.order) == len(tree.panels) - 1
    # The flaps of FEFCO 0200 and 0201 meet; those of 0203 overlap wholly, as the standard says.
    found = {name: {f.message.code for f in find_faults(tree)} for name, tree in trees.items()}
    assert found["f0200_B_300x200x150"] == found["f0201_B_400x300x250"] == set()
    assert found["f0203_B_350x250x100"] == {"folding.flaps-overlap"}
