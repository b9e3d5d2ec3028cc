"""allowances: what the thickness of a board adds to the inner dimensions of a carton.

A crease is in the middle of its board.  The distance between two creases at which a panel is folded
by 90° is therefore the inner dimension plus t/2 at either end, where t is the caliper.  Flaps that
lie on each other add their thickness.  These sums agree with tables of the trade: PackageIt, "Box
101", subtracts 3/16 in, 3/16 in and 3/8 in from the creases of a slotted case in C-flute (4 mm),
that is 1.2 t, 1.2 t and 2.4 t.  All other allowances are common practice on sample tables; tables
of makers of board differ by up to t/2, because flutes are crushed.
"""

from __future__ import annotations


def between_folds(t: float) -> float:
    """Return what a panel between two folds adds to its inner dimension, for a caliper t (mm)."""
    return t


def slotted_depth(t: float) -> float:
    """Return what the depth of a slotted case adds, whose outer flaps lie on inner flaps (mm)."""
    return 2.0 * t


def overlapped_depth(t: float) -> float:
    """Return what the depth of a case adds, whose outer flaps overlap on inner flaps (mm)."""
    return 3.0 * t


def last_panel(t: float) -> float:
    """Return by how much the panel that is glued to the flap is shorter than its opposite (mm).

    Otherwise its edge would protrude at the joint.  Common practice: t/2, and 0.3 mm at least.
    """
    return max(0.5 * t, 0.3)


def slot_width(t: float) -> float:
    """Return the width of a slot between flaps (mm): common practice, t + 1 mm."""
    return t + 1.0


def lock_slot(t: float) -> float:
    """Return the width of a slot that receives a tab (mm): common practice, t + 0.5 mm."""
    return t + 0.5


def play(t: float) -> float:
    """Return the distance between parts that slide past each other (mm).

    Common practice: t/4, and 0.5 mm at least.
    """
    return max(0.25 * t, 0.5)
