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
    TABLE,  # word of the table that is open, 0 before its name, -1 for none
    NAMED,  # what is open in it has a name
    ENTITIES,
    VERTICES,
    BLOCKS,
    LAYERS,
    NAMES,
    UNSURES,
    OTHERS,  # handles of all that is no entity
    MOST_ENTITIES,  # rows from here on are another run's
    MOST_VERTICES,
    MOST_OTHERS,
    HEADER_FIRST,
    HEADER_LAST,
) = range(27)
STATES: Final = 27
# Modes.
(
    NOTHING, IN_SECTION, IN_TABLE, IN_LAYER, IN_STYLE, IN_ROW, IN_OBJECTS, IN_BLOCK, IN_ENTITY,
    IN_VERTEX,
) = range(10)  # fmt: skip
# What becomes of the pass.
ON, DONE, REFUSED = range(3)
