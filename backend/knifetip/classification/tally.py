"""tally: how much of each style has which role, and which edges are decided alike.

Shape, style of each edge -> Tally -> cells
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.classification.evidence import Shape
from knifetip.classification.role import Role
from knifetip.geometry.columns import F64, I64
from knifetip.kernels import (
    F64_1,
    I64_1,
    U8_1,
    Bool_1,
    OutF64_1,
    OutF64_2,
    OutI64_1,
    OutI64_2,
    kernel,
)

#: Flags of a cell beside its style and role.
MIXED: Final = 1  #: a third of the edge has another role
TEXT: Final = 2  #: a text stands beside it
HOLDS: Final = 4  #: a panel hangs on it
FLAGS: Final = 8
_ROLES: Final = len(Role)
_STRAY, _DIVIDER, _UNKNOWN = (int(role) for role in (Role.STRAY, Role.DIVIDER, Role.UNKNOWN))
#: Less than this share of an edge in one role leaves a third in another.
_SURE: Final = 0.7
#: So much of what holds panels in a style are dashes where all its dashes do.
_MOSTLY: Final = 0.9


class Tally(NamedTuple):
    """What is drawn in each of c styles."""

    edges: I64  #: (c, roles) how many
    length: F64  #: (c, roles) how long they are
    dashes: F64  #: (c,) the length of dividers that are dashes
    pairs: F64  #: (c,) the length of dividers that have a partner beside them
    holds: F64  #: (c,) the length of dividers on which panels hang
    held: F64  #: (c, 2) the length of all on which panels hang, and of what of it are dashes

    @classmethod
    def of(cls, style: I64, styles: int, seen: Shape, lengths: F64) -> Tally:
        """Add up what is drawn, in the order of the drawing.

        Parameters
        ----------
        style, lengths : (n,)
            Of each edge the style, of so many, and the length.
        """
        made = cls(
            np.zeros((styles, _ROLES), np.int64),
            np.zeros((styles, _ROLES)),
            np.zeros(styles),
            np.zeros(styles),
            np.zeros(styles),
            np.zeros((styles, 2)),
        )
        _add(style, lengths, seen.role, seen.dashed, seen.paired, seen.holds, *made)
        return made

    def cells(self, style: I64, seen: Shape) -> I64:
        """Return a number of each edge that is the same for all that are decided alike, (n,).

        Style × role × flags.
        """
        held, dashed = self.held.T
        cell = np.empty(len(style), np.int64)
        _number(
            style,
            seen.role,
            seen.sure,
            seen.annotated,
            seen.holds,
            seen.dashed,
            (dashed > _MOSTLY * held) & (held > 0.0),
            cell,
        )
        return cell


@kernel(allocates=False)
def _add(
    style: I64_1,
    lengths: F64_1,
    role: U8_1,
    dashed: Bool_1,
    paired: Bool_1,
    held: Bool_1,
    count: OutI64_2,
    length: OutF64_2,
    dashes: OutF64_1,
    pairs: OutF64_1,
    holds: OutF64_1,
    all_held: OutF64_2,
) -> None:
    for i in range(len(style)):
        s, long = style[i], lengths[i]
        count[s, role[i]] += 1
        length[s, role[i]] += long
        if held[i]:
            all_held[s, 0] += long
            if dashed[i]:
                all_held[s, 1] += long
        if role[i] == _DIVIDER:
            if dashed[i]:
                dashes[s] += long
            if paired[i]:
                pairs[s] += long
            if held[i]:
                holds[s] += long


@kernel(allocates=False)
def _number(
    style: I64_1,
    role: U8_1,
    sure: F64_1,
    annotated: Bool_1,
    holds: Bool_1,
    dashed: Bool_1,
    dashes_hold: Bool_1,
    cell: OutI64_1,
) -> None:
    for i in range(len(style)):
        flags = 0
        if sure[i] < _SURE and role[i] != _UNKNOWN:
            flags += MIXED
        if annotated[i] and role[i] == _STRAY:
            flags += TEXT
        if role[i] == _DIVIDER and (holds[i] or (dashed[i] and dashes_hold[style[i]])):
            flags += HOLDS
        cell[i] = (style[i] * _ROLES + role[i]) * FLAGS + flags
