"""state: indices into the array of integers that holds the state of a scan.

The state contains the open section, table, block and entity, and the numbers of rows.
"""

from __future__ import annotations

from typing import Final

(
    SECTION,  # word, -1 outside of any
    SECTIONS,  # seen so far, as bits
    INSIDE,  # row of the open block, or -1
    MODE,  # context of the tags
    ROW,  # of the open entity, -1 for none
    CONTEXT,  # the row of ``group_codes.ACTION`` for it
    OPEN_KIND,  # its kind while it is supported, ``OF_WORDS`` for texts
    SEEN,
    OPEN_MARKS,
    CHAIN,  # row of the POLYLINE whose vertices follow, or -1
    FOLLOWED,  # ATTRIBs and a SEQEND follow
    GROUP,  # 1 within {…}, 2 in extension data
    IS_MTEXT,
    TABLE,  # keyword of the open table, 0 before its name, -1 for none
    NAMED,  # whether its open row has a name
    ENTITIES,
    VERTICES,
    BLOCKS,
    LAYERS,
    NAMES,
    UNSURES,
    OTHERS,  # handles of other objects
    MOST_ENTITIES,  # first row of the next run
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
# Results of the scan.
ON, DONE, REFUSED = range(3)
