"""boundary: find the grooves that end on the board's edge, and how far they must run out past it.

A tool of width W cuts a strip that extends W/2 to the left and W/2 to the right of the groove's
line.  Across the direction of travel, the tool is a line from the left border of this strip to the
right border.  The tool has left the board when both ends of this line are outside.

At a straight edge of the board this takes a run-out of (W/2) |n·m| / (u·m), where m is the edge's
outward normal, u the direction of the groove and n the groove's normal.  At a round edge the
sagitta of the edge is added.  At an outer corner of the outline the tool has left the board once it
is past one of the two edges.  At an inner corner (a notch) each half of the tool must be past both
edges.

An end of a groove gets no run-out if the groove, continued beyond this end, would enter the board
or run along the board's edge within 5°.  Such an end counts as inside the board; there the board's
``groove_overcut`` limits how far the blade may cut beyond the end.

Source of the run-out at a straight edge: "A new method of turning processing in multi axis linkage
NC machining", section 1.  The formulas for corners and round edges were derived for knifetip.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sin

import numpy as np

from knifetip.errors import FlankOutside
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I8, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.run_out import corner_run_outs
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import GAP
from knifetip.planning.cut_crossings import inner_crossings
from knifetip.planning.cut_sides import CutSides, cut_sides
from knifetip.topology.noding import split_at_crossings

#: A groove that meets the edge at a smaller angle runs along it (sine).
_ALONG = sin(radians(5.0))


@dataclass(frozen=True, eq=False, slots=True)
class BoardOutline:
    """The outline of the board: n edges of parts, each directed with the waste on its left."""

    start: F64  #: (n, 2) mm
    end: F64  #: (n, 2) mm
    bulge: F64  #: (n,)

    @classmethod
    def from_cuts(cls, ends: F64, bulge: F64, side: I8) -> BoardOutline:
        """Return the outline of the board from those cuts that have waste on one side.

        Parameters
        ----------
        ends, bulge : (n, 2, 2) mm and (n,)
            Start and end points, and bulges, of all cuts.
        side : (n,)
            Side of the waste of each cut: +1 left, -1 right, 0 if the cut is no outline of a part.
        """
        rows = np.flatnonzero(side)
        back = (side[rows] < 0)[:, None]
        start, end = ends[rows, 0], ends[rows, 1]
        bent = np.where(back[:, 0], -bulge[rows], bulge[rows])
        return cls(np.where(back, end, start), np.where(back, start, end), bent)

    @classmethod
    def from_contours(
        cls, ends: F64, bulge: F64, sides: CutSides
    ) -> tuple[BoardOutline, BoardOutline]:
        """Return the outline of the parts, and the outline of all board, which has holes.

        Where contours touch or cross between their vertices, they are divided, because the side of
        the waste changes there: contours that meet bound one component, and all its faces are
        panels.

        Parameters
        ----------
        ends, bulge : (n, 2, 2) mm and (n,)
            Start and end points, and bulges, of all cuts.
        sides
            Sides of the cuts if they meet only at their ends.
        """
        waste, removed = sides.waste, sides.removed
        contour = np.flatnonzero(removed)
        pieces, bent, row = split_at_crossings(ends[contour], bulge[contour])
        if len(row) > len(contour):
            divided = cut_sides(pieces, bent)
            ends, bulge, waste, removed = pieces, bent, divided.waste, divided.removed
        return cls.from_cuts(ends, bulge, waste), cls.from_cuts(ends, bulge, removed)

    @property
    def edges(self) -> Paths:
        """The edges as one path, which is not continuous."""
        return Paths(self.start, self.end, self.bulge, np.array([0, len(self.bulge)]))


@dataclass(frozen=True, eq=False, slots=True)
class Contacts:
    """k contacts: pairs of an end of a groove and a cut of the outline on which that end lies."""

    end: I64  #: (k,) index of the end
    cut: I64  #: (k,) index of the cut
    normal: F64  #: (k, 2) outward unit normal of the cut at the contact
    tangent: F64  #: (k, 2) unit tangent of the cut at the contact
    gap: F64  #: (k, 2) mm, vector from the end to the cut
    radius: F64  #: (k,) mm, of the cut; infinite for a line
    arrives: Bool  #: (k,) the cut finishes at the contact
    leaves: Bool  #: (k,) the cut starts at the contact


def run_out_lengths(
    points: F64, ahead: F64, width: float, outline: BoardOutline, source: I32
) -> tuple[F64, Bool]:
    """Return how far a tool must run out beyond each of n ends of grooves, and which of these ends
    lie on the board's edge.

    Parameters
    ----------
    points, ahead : (n, 2) mm and (n, 2)
        Ends of grooves, and at each end the unit vector that points out of the groove.
    width : mm
        Width of the tool or of the groove.
    outline
        Outline of the board.
    source : (n,)
        Index in the dieline of the edge to which each end belongs, for error messages.

    Returns
    -------
    Run-out of each end (n,) mm, 0 inside the board; mask of the ends on the board's edge (n,).

    Raises
    ------
    FlankOutside
        A groove meets the board's edge at less than 5°, or its run-out would enter the board again.
    """
    contacts = find_contacts(points, outline)
    u, m = ahead[contacts.end], contacts.normal
    sine = (u * m).sum(axis=1)
    leaves = np.flatnonzero(sine > _ALONG)
    _check_angles(contacts, sine, source)
    end, u, m, radius = contacts.end[leaves], u[leaves], m[leaves], contacts.radius[leaves]
    sagitta = np.minimum(width / 2.0 / sine[leaves], radius) ** 2 / (2.0 * radius)
    short = np.maximum((contacts.gap[leaves] * m).sum(axis=1), 0.0)
    needed = corner_run_outs(u, m, width, sagitta + short)

    count = len(points)
    on_edge, corner = _leaving_ends(contacts, sine, count)
    farthest, nearest = np.zeros((count, 2)), np.full((count, 2), np.inf)
    np.maximum.at(farthest, end, needed)
    np.minimum.at(nearest, end, needed)
    longest = np.where(corner[:, None], nearest, farthest).max(axis=1)
    size = np.where(on_edge, np.maximum(longest, 0.0), 0.0)
    _check_run_outs(points, ahead, size, width, contacts, outline, source)
    return size, on_edge


def ends_at_waste(points: F64, ahead: F64, outline: BoardOutline) -> Bool:
    """Return the mask of the ends of cuts on the board's edge that have waste ahead of them, (n,).

    A cut that makes an angle of less than 5° with the board's edge has no waste ahead of its end.

    Parameters
    ----------
    points, ahead : (n, 2) mm and (n, 2)
        Ends of cuts, and at each end the unit vector that points out of the cut.
    outline
        Outlines of the board and of its holes.
    """
    contacts = find_contacts(points, outline)
    sine = (ahead[contacts.end] * contacts.normal).sum(axis=1)
    return _leaving_ends(contacts, sine, len(points))[0]


def _leaving_ends(contacts: Contacts, sine: F64, count: int) -> tuple[Bool, Bool]:
    """Return the masks of the ends at which a line leaves the board, and of the ends at an outer
    corner of the outline, (count,) each.

    ``contacts``: contacts of ``count`` ends of lines with the outline.
    ``sine`` (k,): sine of the angle between the line and the outline at each contact, positive
    towards the waste.
    """
    contact_count = np.bincount(contacts.end, minlength=count)
    leaving_count = np.bincount(contacts.end[sine > _ALONG], minlength=count)
    # At an outer corner leaving over one edge suffices; in a notch the tool must leave over both.
    corner = _corner_turns(contacts, count) < -1e-6
    leaving: Bool = (contact_count > 0) & (leaving_count >= np.where(corner, 1, contact_count))
    return leaving, corner


def _check_run_outs(
    points: F64,
    ahead: F64,
    size: F64,
    width: float,
    contacts: Contacts,
    outline: BoardOutline,
    source: I32,
) -> None:
    """Raise ``FlankOutside`` if the run-out of a groove enters the board again, behind a slot or in
    another part.

    ``points``, ``ahead`` (n, 2) mm and (n, 2): ends of grooves, and at each end the unit vector
    that points out of the groove.
    ``size`` (n,) mm: length of the run-out of each end.
    ``width`` mm: width of the tool or of the groove.
    ``contacts``: contacts of the ends with the outline; the run-out may cross the cuts of these
    contacts.
    ``source`` (n,): index in the dieline of the edge to which each end belongs, for the error
    message.
    """
    rows = np.flatnonzero(size > GAP)
    start, end = points[rows], points[rows] + size[rows, None] * ahead[rows]
    # Tracks: of the middle of the tool, and across the tool where it stops.  The latter is slightly
    # shorter than the tool is wide, since the corner that leaves last is exactly on the edge.
    half = 0.499 * width * left_normal(ahead[rows])
    tracks = Paths(
        np.concatenate([start, end + half]),
        np.concatenate([end, end - half]),
        np.zeros(2 * len(rows)),
        np.arange(2 * len(rows) + 1, dtype=np.int32),
    )
    track, cut, _ = inner_crossings(
        tracks, np.stack([outline.start, outline.end], axis=1), outline.bulge
    )
    row = np.tile(rows, 2)[track]
    count = len(outline.bulge)
    reentries = np.flatnonzero(~np.isin(row * count + cut, contacts.end * count + contacts.cut))
    if len(reentries):
        bad = source[row[reentries]]
        raise FlankOutside(
            "groove.runs-out", edge=bad[0], distance=size[row[reentries[0]]], at_edges=bad
        )


def _check_angles(contacts: Contacts, sine: F64, source: I32) -> None:
    """Raise ``FlankOutside`` if a groove ends on one edge of the board, not at a corner, and the
    angle between the two is less than 5°.

    ``sine`` is the sine of the angle between the groove and the board's edge at each contact, (k,).
    ``source`` is the index in the dieline of the edge of each end of a groove, for the message.
    """
    is_single = np.bincount(contacts.end, minlength=len(source)) == 1
    along = np.flatnonzero((sine > 1e-9) & (sine <= _ALONG) & is_single[contacts.end])
    if len(along):
        bad = source[contacts.end[along]]
        angle = np.degrees(np.arcsin(sine[along[0]]))
        raise FlankOutside("groove.along-edge", edge=bad[0], angle=angle, at_edges=bad)


def find_contacts(points: F64, outline: BoardOutline) -> Contacts:
    """Return the contacts of n points, (n, 2) mm, with cuts of the outline.

    A point and a cut are in contact if their distance is at most ``GAP`` mm.
    """
    boxes = arc.bounding_boxes(outline.start, outline.end, outline.bulge)
    end, cut = box_pairs(arc.point_boxes(points), boxes, GAP)
    start, finish, bulge = outline.start[cut], outline.end[cut], outline.bulge[cut]
    point = points[end]
    along = arc.nearest_fraction(start, finish, bulge, point)
    contact_point = arc.point_at(start, finish, bulge, along)
    gap = contact_point - point
    touch = np.hypot(gap[:, 0], gap[:, 1]) <= GAP
    tangent = unit_vectors(arc.tangent_at(start, finish, bulge, along))
    near_end = np.hypot(*(finish - point).T) <= GAP
    near_start = np.hypot(*(start - point).T) <= GAP
    return Contacts(
        end[touch],
        cut[touch],
        left_normal(tangent)[touch],
        tangent[touch],
        gap[touch],
        arc.radius(start, finish, bulge)[touch],
        near_end[touch],
        near_start[touch],
    )


def _corner_turns(contacts: Contacts, count: int) -> F64:
    """Return the sine of the angle by which the outline turns at each end of a groove, (count,).

    The sine is positive in a notch, negative at an outer corner (a right turn, since the waste is
    on the left), and 0 if the outline has no corner there.  ``contacts`` are the contacts of
    ``count`` ends of grooves with the outline.
    """
    arriving, leaving = np.zeros((count, 2)), np.zeros((count, 2))
    arriving[contacts.end[contacts.arrives]] = contacts.tangent[contacts.arrives]
    leaving[contacts.end[contacts.leaves]] = contacts.tangent[contacts.leaves]
    two = np.bincount(contacts.end, minlength=count) == 2
    turn = arriving[:, 0] * leaving[:, 1] - arriving[:, 1] * leaving[:, 0]
    return np.where(two, turn, 0.0)
