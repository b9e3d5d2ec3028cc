"""edge_feeds: lower the feed along the edges for which a user has chosen a feed factor."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.model.chosen_work import ChosenWork
from knifetip.model.job_options import EdgeFeed
from knifetip.model.toolpath import Motion, Toolpath


def with_edge_feeds(toolpath: Toolpath, chosen: ChosenWork) -> Toolpath:
    """Return a toolpath whose moves along edges have the chosen part of their feed.

    Plunges, leads and turns in place keep theirs.  ``chosen`` is for the edges of the dieline to
    which the column ``source`` of the toolpath refers.
    """
    if EdgeFeed not in chosen:
        return toolpath
    factor = chosen[EdgeFeed].numbers("factor", 1.0)
    along = (toolpath.motion == Motion.FEED) & (toolpath.source >= 0)
    return replace(toolpath, feed=toolpath.feed * np.where(along, factor[toolpath.source], 1.0))
