"""segments: the segments of each entity of a scanned file, before any block is placed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.dxf.fast_reader.columns import count_segments, draw
from knifetip.dxf.fast_reader.scan import Scan
from knifetip.geometry.columns import F64, I64


class EntitySegments(NamedTuple):
    """The n segments of all e entities of a scanned file.

    They are in the coordinates of model space, or of the block that contains the entity.
    """

    number: I64  #: (e,) number of segments of each entity
    first: I64  #: (e + 1,) first segment of each entity; the last element is n
    ends: F64  #: (n, 2, 2) start and end point of each segment (file units)
    bulge: F64  #: (n,)


def segments_of(scanned: Scan) -> EntitySegments:
    """Return the segments of all e entities of a scanned file.

    Entities with an invalid radius or angle are marked in the column ``UNSUPPORTED``
    of ``Scan.entity``.
    """
    count: I64 = count_segments(scanned.entity, scanned.value, scanned.vertex)
    first: I64 = np.concatenate([[0], np.cumsum(count)])
    ends, bulge = np.empty((first[-1], 2, 2)), np.empty(first[-1])
    draw(scanned.entity, scanned.value, scanned.vertex, first, ends, bulge)
    return EntitySegments(count, first, ends, bulge)
