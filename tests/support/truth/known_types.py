"""Drawings by other authors whose line types are known, with the source of this knowledge.

The sources are the list in the corpus and the conventions of the generators that drew the files.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from knifetip.cleaning.clean import clean
from knifetip.geometry.columns import F64, U8, Bool
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import NO_LINE_WIDTH, Drawing

CUT, CREASE = LineType.CUT, LineType.CREASE
HALF_CUT, IGNORED = LineType.HALF_CUT, LineType.IGNORED

_OBRARY = "Obrary__Parametric-Papercraft/Interchange-Files"
_RSC = "generated__bikinon__RSC-FEFCO-02xx"
_MAILER = "generated__kyholdings__diecut_generator"


@dataclass(frozen=True)
class Known:
    """A drawing of the corpus with the line type for each layer and colour."""

    path: str
    line_type_of: Callable[[str, int], LineType]  #: maps layer and colour index to the line type

    def truth(self, drawing: Drawing) -> U8:
        """Return the correct LineType of each edge, (n,)."""
        pairs = zip(drawing.layer.tolist(), drawing.colour.tolist(), strict=True)
        return np.array(
            [self.line_type_of(drawing.layers[layer], colour) for layer, colour in pairs], "u1"
        )


def _layers(**kinds: LineType) -> Callable[[str, int], LineType]:
    return lambda layer, _colour: kinds[layer.replace("-", "_")]


def _design(_layer: str, colour: int) -> LineType:
    return CUT if colour == 1 else CREASE


def _label(layer: str, _colour: int) -> LineType:
    return IGNORED if layer.endswith("_labelLayer") else CUT


def _all_cut(_layer: str, _colour: int) -> LineType:
    return CUT


KNOWN = (
    Known(f"{_OBRARY}/cube.dxf", _layers(CUTS=CUT, FOLDS=CREASE)),
    Known(f"{_OBRARY}/long.dxf", _layers(CUTS=CUT, FOLDS=CREASE)),
    Known(
        f"{_MAILER}/mailer_120x80x40_all_layers.dxf",
        _layers(CUT=CUT, CREASE=CREASE, HALFCUT=HALF_CUT, DIMENSION=IGNORED),
    ),
    Known(f"{_MAILER}/mailer_200x150x60_t3.dxf", _layers(CUT=CUT, CREASE=CREASE)),
    Known(f"{_RSC}/f0200_B_300x200x150.dxf", _design),
    Known(f"{_RSC}/f0201_B_400x300x250.dxf", _design),
    Known(f"{_RSC}/f0203_B_350x250x100.dxf", _design),
    Known(
        "generated__minrogi__PLMPackLib-f421/F0421_400x300x100.dxf",
        _layers(LT_CUT=CUT, LT_FOLD=CREASE),
    ),
    Known(
        "generated__eridur-de__mightyscape-inkpacking/box_rwlf.dxf",
        _layers(C00_00_00_BLACK=CUT, CFF_00_00=CREASE),
    ),
    Known("Jayanthan-Amalanathan__laser-cutting-and-engraving/box.dxf", _label),
    Known("suhail-jr__Manual-pnP/cut.dxf", _all_cut),
    Known(
        "groupdocs-viewer__GroupDocs.Viewer-for-.NET/Examples/GroupDocs.Viewer.Examples.CSharp/"
        "Resources/SampleFiles/sample.cf2",
        _all_cut,
    ),
)


def without_names(drawing: Drawing) -> Drawing:
    """Return the drawing with all edges on layer 0 and with their colours."""
    return replace(drawing, layer=np.zeros(len(drawing), np.int32), layers=("0",))


def without_style(drawing: Drawing) -> Drawing:
    """Return the drawing with all edges on layer 0, in one colour, linetype and line width."""
    count = len(drawing)
    return replace(
        without_names(drawing),
        colour=np.full(count, 7, np.int32),
        true_colour=np.full(count, -1, np.int32),
        linetype=np.zeros(count, np.int32),
        linetypes=("CONTINUOUS",),
        line_width=np.full(count, NO_LINE_WIDTH, np.int32),
    )


def replaced_by_cuts(drawing: Drawing, truth: U8) -> Bool:
    """Return the mask of edges that are not made, because cuts lie on their whole length, (n,).

    They are on the same lines whatever their line type is called: the cuts are made.  ``truth`` is
    the correct LineType of each of the n edges.
    """
    count = len(drawing)
    dieline = Dieline(
        drawing.ends,
        drawing.bulge,
        truth,
        np.arange(count, dtype=np.int32),
        np.zeros(count, np.int32),
        np.ones(count),
        (Message("classification.override"),),
    )
    cleaned = clean(dieline)
    parts = cleaned.stretches
    is_cut = cleaned.dieline.line_type[np.maximum(parts.cleaned, 0)] == CUT
    rows = np.flatnonzero(parts.by_other_edge & (parts.cleaned >= 0) & is_cut)
    covered = np.bincount(parts.row[rows], (parts.end - parts.begin)[rows], count)
    replaced: Bool = (covered > 1.0 - 1e-6) & (truth != CUT)
    return replaced


def classification_fractions(truth: U8, line_type: U8, weight: F64) -> tuple[float, float, float]:
    """Return the fractions of the total weight that are right, unclassified, and wrong.

    Parameters
    ----------
    truth, line_type : (n,) LineType
        The correct and the determined line type of each edge.
    weight : (n,)
        Weight of each edge, for example its length.
    """
    unclassified = line_type == LineType.UNCLASSIFIED
    right = line_type == truth
    total = weight.sum() or 1.0
    right_fraction, unclassified_fraction = (
        float(weight[rows].sum() / total) for rows in (right & ~unclassified, unclassified)
    )
    return (
        right_fraction,
        unclassified_fraction,
        float(weight[~right & ~unclassified].sum() / total),
    )
