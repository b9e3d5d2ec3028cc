"""enclosed_tracks: mill what a closed track encloses before this track.

A neck in the waste that is narrower than the cutter divides the offset of a contour, as beside a
part with a bay whose mouth is narrow: one track runs round the part and past the mouth, another one
in the bay.  The disc of the outer track cuts through the mouth, so this track releases the part
together with the waste in the bay.  The track in the bay would then be cut in a loose piece.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.geometry.columns import I64
from knifetip.geometry.path import Paths
from knifetip.model.tool import DiscTool, Tool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.topology.exact_nesting import find_enclosing_faces


def split_enclosed(toolpath: Toolpath, tool: Tool) -> list[Toolpath]:
    """Return the toolpath of an operation as several ones in working order, so that no track
    follows one that encloses it.

    A toolpath without enclosed tracks is returned whole, and so is that of a tool that is no disc:
    the cuts of a knife are ordered when they are planned.
    """
    if not isinstance(tool, DiscTool):
        return [toolpath]
    tracks, paths = _last_passes(toolpath)
    depth = _nesting_depths(paths)
    if not depth.any():
        return [toolpath]
    result: list[Toolpath] = []
    for level in np.unique(depth)[::-1]:
        kept = np.isin(toolpath.track, tracks[depth == level])
        # The air move to a track belongs to no track.
        kept[:-1] |= kept[1:] & (toolpath.track[:-1] < 0)
        rows = np.flatnonzero(kept)
        pose = np.concatenate([toolpath.pose[rows[:1]], toolpath.pose[rows + 1]])
        notes = () if result else toolpath.notes
        result.append(replace(toolpath.with_moves(rows, pose), notes=notes))
    return result


def _last_passes(toolpath: Toolpath) -> tuple[I64, Paths]:
    """Return the numbers of q tracks, (q,), and the path of the last pass of each of them, without
    leads.

    A track without feeds along an edge is left out.
    """
    rows = np.flatnonzero((toolpath.motion == Motion.FEED) & (toolpath.track >= 0))
    rows = rows[np.argsort(toolpath.track[rows], kind="stable")]
    tracks, owner = np.unique(toolpath.track[rows], return_inverse=True)
    height = toolpath.pose[rows + 1, 2]
    lowest = np.full(len(tracks), np.inf)
    np.minimum.at(lowest, owner, height)
    last = height == lowest[owner]
    rows, owner = rows[last], owner[last]
    first = np.searchsorted(owner, np.arange(len(tracks) + 1)).astype(np.int32)
    start, end = toolpath.pose[rows, :2], toolpath.pose[rows + 1, :2]
    return tracks.astype(np.int64), Paths(start, end, toolpath.bulge[rows], first)


def _nesting_depths(paths: Paths) -> I64:
    """Return the number of closed paths round each of q paths, (q,).

    The paths must not cross each other.
    """
    if len(paths) < 2:
        return np.zeros(len(paths), np.int64)
    inside = 2 * np.arange(len(paths))
    # An open path encloses nothing: the outer face lies on both its sides.
    left = np.where(paths.closed & (paths.areas > 0.0), inside, inside + 1)
    right = np.where(paths.closed & (paths.areas < 0.0), inside, inside + 1)
    owner = paths.path_of
    _, depth = find_enclosing_faces(
        paths.start,
        paths.end,
        paths.bulge,
        np.stack([left, right], axis=1)[owner].astype(np.int32),
        np.arange(2 * len(paths)) % 2 == 1,
        owner.astype(np.int32),
    )
    return depth
