"""outline_parts: find edges of a cut outline whose layers are named for another line type.

The outline of a blank is not always cut along its whole length: a half-cut or a perforation keeps
the blank in the sheet, and a fold joins it to its neighbour.  Shape alone makes such an edge a cut.
Its line type is that of its layer's name if the names of layers also make the rest of the outline
cuts.  If names make much of an outline no cuts, the names are doubtful, and the edges are asked
about.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.decision.conventions import FOLD_TYPES
from knifetip.classification.decision.profile_rules import LAYER
from knifetip.classification.decision.style_evidence import StyleEvidence
from knifetip.classification.shape.features import ShapeFeatures
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, U8
from knifetip.model.dieline import LineType

#: Confidence in the line type of a part of an outline.
PART_OF_OUTLINE: Final = 0.85
#: Least fraction of the length of an outline that layers named for cuts close.
_MIN_CUT: Final = 0.75
_PART_TYPES: Final = (*FOLD_TYPES, LineType.HALF_CUT)
#: Folds that a style has inside blanks too, unless it was drawn on the wrong layer.
_FOLDS_INSIDE: Final = (LineType.CREASE, LineType.V_GROOVE)


def find_outline_parts(
    evidence: StyleEvidence, features: ShapeFeatures, line_type: U8, length: F64
) -> U8:
    """Return the line type of each edge that is another part of a cut outline, (n,).

    It is UNCLASSIFIED for all other edges, and for edges that have a line type already.

    Parameters
    ----------
    evidence
        The evidence about the c styles of the drawing.
    features
        Shape features of the n edges.
    line_type, length : (n,) each
        LineType of each edge as decided so far, and its length.
    """
    found = np.full(len(line_type), LineType.UNCLASSIFIED, np.uint8)
    rows = np.flatnonzero(features.role == Role.OUTLINE)
    is_open = line_type[rows] == LineType.UNCLASSIFIED
    if evidence.swapped or not is_open.any():
        return found
    named = np.array([_named_type(evidence, style) for style in range(len(evidence.styles))])
    own = named[evidence.styles.row[rows]]
    blank, lengths = features.component[rows], length[rows]
    is_cut = (own == LineType.CUT) & (line_type[rows] == LineType.CUT)
    outline = np.bincount(blank, lengths)
    cut = np.bincount(blank, np.where(is_cut, lengths, 0.0))
    parts = is_open & np.isin(own, _PART_TYPES) & (cut >= _MIN_CUT * outline)[blank]
    found[rows[parts]] = own[parts]
    return found


def _named_type(evidence: StyleEvidence, style: int) -> LineType:
    """Return the line type that the layer of a style is named for, UNCLASSIFIED for none.

    A profile rule for the layer has priority over the words of its name.  A style of creases or
    grooves must have more of them inside blanks than on outlines.
    """
    if evidence.matches.rule[style] >= 0:
        by_layer = evidence.matches.confidence[style] >= LAYER
        kind = LineType(int(evidence.matches.line_type[style])) if by_layer else None
    else:
        style_meaning, by_layer = evidence.style_meaning(style)
        # A word for cuts and a word for folds in one name need not mean a combined line type.
        unclear = style_meaning.denied or (
            style_meaning.kind == LineType.COMBI and " " in style_meaning.word
        )
        kind = None if unclear or not by_layer else style_meaning.kind
    length = evidence.length[style]
    if kind in _FOLDS_INSIDE and length[Role.DIVIDER] <= length[Role.OUTLINE]:
        return LineType.UNCLASSIFIED
    return LineType.UNCLASSIFIED if kind is None else kind
