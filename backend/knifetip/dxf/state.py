"""state: what is open while a file is passed over, and how much there is of everything.

Places in one row of numbers, which every part of the pass reads and writes.
"""

from __future__ import annotations

from typing import Final

(
    SECTION,  # word, -1 outside of any
    SECTIONS,  # that there were, as bits
    INSIDE,  # row of the block that is open, or -1
    MODE,  # what the tags belong to
    ROW,  # of the entity that is open, -1 for none
    CONTEXT,  # the row of ``groups.ACTION`` that this makes
    OPEN_KIND,  # its kind while it is plain, ``OF_WORDS`` for words
    SEEN,
    OPEN_MARKS,
    CHAIN,  # row of the POLYLINE whose vertices follow, or -1
    FOLLOWED,  # ATTRIBs and a SEQEND follow
    GROUP,  # 1 within {…}, 2 in what other programs have added
    IS_MTEXT,
    NAMED,  # an entry of another table than that of layers
    ENTITIES,
    VERTICES,
    BLOCKS,
    LAYERS,
    NAMES,
    UNSURES,
    HEADER_FIRST,
    HEADER_LAST,
) = range(22)
STATES: Final = 22
# Modes.
NOTHING, IN_SECTION, IN_LAYER, IN_TABLE, IN_BLOCK, IN_ENTITY, IN_VERTEX = range(7)
# What becomes of the pass.
ON, DONE, REFUSED = range(3)
