"""style_totals: sum up lengths and numbers of edges by style and role.

The module also computes decision keys.  A decision key is an integer that combines the style and
the role of an edge with flags, such as whether a text is near it.  Edges with equal keys get the
same decision.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.shape.features import ShapeFeatures
from knifetip.classification.shape.open_dividers import DividerKind
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I64
from knifetip.kernels import (
    F64_1,
    I64_1,
    U8_1,
    Bool_1,
    OutF64_1,
    OutF64_2,
    OutI64_2,
    kernel,
)

#: Flags in a decision key, beside style and role.
MIXED_ROLES: Final = 1  #: at least a third of the edge has another role
NEAR_TEXT: Final = 2  #: a text is beside the edge
MUST_FOLD: Final = 4  #: a panel is attached by the edge alone
BESIDE_GAP: Final = 8  #: the edge divides two panels only if the outline lacks a line
FLAG_COUNT: Final = 16
#: Number of values of ``DividerKind``.
DIVIDER_KINDS: Final = len(DividerKind)
_ROLES: Final = len(Role)
_STRAY, _DIVIDER, _UNKNOWN = (int(role) for role in (Role.STRAY, Role.DIVIDER, Role.UNKNOWN))
_OUTLINE, _OPEN_FLAP = int(Role.OUTLINE), int(DividerKind.OPEN_FLAP)
#: An edge with less than this fraction of its length in its main role has mixed roles.
_MAIN_ROLE: Final = 0.7
#: If more than this fraction of a style's necessary folds is dashed, all its dashes are folds.
_MOSTLY_DASHED: Final = 0.9


class StyleTotals(NamedTuple):
    """Numbers and total lengths of the edges of each of c styles, by the role of the edges."""

    edges: OutI64_2  #: (c, roles) number of edges
    length: OutF64_2  #: (c, roles) length of the edges
    dashed: OutF64_1  #: (c,) length of dividers in rows of dashes
    paired: OutF64_1  #: (c,) length of dividers with a parallel line beside them
    must_fold: OutF64_1  #: (c,) length of dividers that must be folds
    #: (c, 2) length of all edges that must be folds, and of dashed edges that must be folds
    fold_lengths: OutF64_2

    @classmethod
    def sum(cls, style: I64, styles: int, features: ShapeFeatures, lengths: F64) -> StyleTotals:
        """Return the number and the total lengths of the edges of each style, by role.

        Parameters
        ----------
        style : (n,)
            Index of the style of each edge.
        styles
            Number of styles, c.
        features
            Shape features of the edges, which contain their roles.
        lengths : (n,)
            Length of each edge.
        """
        totals = cls(
            np.zeros((styles, _ROLES), np.int64),
            np.zeros((styles, _ROLES)),
            np.zeros(styles),
            np.zeros(styles),
            np.zeros(styles),
            np.zeros((styles, 2)),
        )
        _add(
            style,
            lengths,
            features.role,
            features.dashed,
            features.paired,
            features.must_fold,
            totals,
        )
        return totals

    def decision_keys(self, style: I64, features: ShapeFeatures) -> I64:
        """Return the decision key of each edge, (n,): a number for style, roles, kind and flags.

        Edges with equal keys get the same decision.  The roles are that of the edge and that of
        most of the rest of its length, if the rest is large.  The kind is the DividerKind of
        edges that may be slits or folds.  The flags state whether less than 70 % of the edge's
        length has its role, whether a text is near an edge outside all blanks, whether a divider
        must be a fold, and whether it divides panels only if the outline lacks a line.  ``style``
        (n,) is the style of each edge, and ``features`` are the shape features of the edges.
        """
        all_folds, dashed_folds = self.fold_lengths.T
        dashes_fold = (dashed_folds > _MOSTLY_DASHED * all_folds) & (all_folds > 0.0)
        key: I64 = _decision_keys(
            style,
            _Roles(features.role, features.role_fraction, features.second_role),
            features.near_text,
            features.must_fold | (features.dashed & dashes_fold[style]),
            features.beside_gap,
            features.divider_kind,
        )
        return key


class _Roles(NamedTuple):
    """The roles of n edges."""

    role: U8_1  #: (n,) Role of the greatest part of each edge's length
    fraction: F64_1  #: (n,) fraction of the edge's length that has this role, 0 … 1
    second: U8_1  #: (n,) Role of most of the rest of its length


def lengths_without_covered(style: I64, features: ShapeFeatures, lengths: F64) -> F64:
    """Return the length of each of n edges, (n,), but 0 for lines drawn on the outline again.

    Such a line coincides with an edge of the outline that has another style, and the other style
    closes more of the outlines.  It does not show that its own style closes outlines.

    Parameters
    ----------
    style, lengths : (n,) each
        Style and length of each edge.
    features
        Shape features of the edges.
    """
    covered = np.flatnonzero((features.coincident >= 0) & (features.role == Role.OUTLINE))
    covered = covered[style[features.coincident[covered]] != style[covered]]
    if len(covered) == 0:
        return lengths
    closing = np.bincount(style, np.where(features.role == Role.OUTLINE, lengths, 0.0))
    other = style[features.coincident[covered]]
    own = lengths.copy()
    own[covered[closing[style[covered]] < closing[other]]] = 0.0
    return own


@kernel(allocates=False)
def _add(
    style: I64_1,
    lengths: F64_1,
    role: U8_1,
    dashed: Bool_1,
    paired: Bool_1,
    must_fold: Bool_1,
    totals: StyleTotals,
) -> None:
    """Add the number and the lengths of n edges to the totals of their styles.

    ``style``, ``lengths``, ``role`` (n,) each: style, length and role of each edge.
    ``dashed``, ``paired``, ``must_fold`` (n,) each: whether each edge is a dash, has a parallel
    line beside it, and must be a fold.
    """
    count, length, dashed_length, paired_length, must_fold_length, fold_lengths = totals
    for i in range(len(style)):
        s, edge_length = style[i], lengths[i]
        count[s, role[i]] += 1
        length[s, role[i]] += edge_length
        if must_fold[i]:
            fold_lengths[s, 0] += edge_length
            if dashed[i]:
                fold_lengths[s, 1] += edge_length
        if role[i] == _DIVIDER:
            if dashed[i]:
                dashed_length[s] += edge_length
            if paired[i]:
                paired_length[s] += edge_length
            if must_fold[i]:
                must_fold_length[s] += edge_length


@kernel
def _decision_keys(
    style: I64_1,
    roles: _Roles,
    near_text: Bool_1,
    must_fold: Bool_1,
    beside_gap: Bool_1,
    divider_kind: U8_1,
) -> Any:
    """Return the decision key of each of n edges, (n,).

    A decision key is an integer that combines the style of an edge, its role, and the role of most
    of the rest of its length, which is its own role unless the rest is large, with four flags: a
    large part of the edge has another role; it is outside all blanks and a text is near it; it is a
    divider that must be a fold; it divides panels only if the outline lacks a line.  It also has
    the kind of the edges that may be slits or folds.

    ``style`` (n,): style of each edge.
    ``near_text``, ``must_fold``, ``beside_gap``, ``divider_kind`` (n,): whether a text is near each
    edge, whether it must be a fold, whether it divides panels only if the outline lacks a line, and
    its DividerKind.
    """
    role, role_fraction, second_role = roles
    key = np.empty(len(style), np.int64)
    for i in range(len(style)):
        flags, second = 0, role[i]
        if role_fraction[i] < _MAIN_ROLE and role[i] != _UNKNOWN:
            flags += MIXED_ROLES
            second = second_role[i]
        if near_text[i] and role[i] == _STRAY:
            flags += NEAR_TEXT
        if role[i] == _DIVIDER and must_fold[i]:
            flags += MUST_FOLD
        if beside_gap[i]:
            flags += BESIDE_GAP
        kind = 0
        if role[i] == _DIVIDER and not flags & MUST_FOLD:
            kind = divider_kind[i]
        elif role[i] == _OUTLINE and divider_kind[i] == _OPEN_FLAP:
            kind = _OPEN_FLAP
        both_roles = (style[i] * _ROLES + role[i]) * _ROLES + second
        key[i] = (both_roles * DIVIDER_KINDS + kind) * FLAG_COUNT + flags
    return key
