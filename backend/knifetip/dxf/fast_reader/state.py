"""state: indices into the array of integers that contains the state of a scan of a DXF file.

The state includes the section, table, block and entity that are being read, and the numbers of rows
that the scan has written into each array.
"""

from __future__ import annotations

from typing import Final

(
    SECTION,  # keyword of the open section, -1 for none
    SECTIONS,  # sections so far, one bit for each keyword
    INSIDE,  # row of the open block, or -1
    MODE,  # context of the tags
    ROW,  # row of the open entity, -1 for none
    CONTEXT,  # row of ``group_codes.ACTION`` for the open entity
    OPEN_KIND,  # kind of the open entity, ``OF_WORDS`` for texts, ``OTHER`` if unsupported
    SEEN,  # tags of the open entity so far, as bits ``group_codes.B_…``
    OPEN_MARKS,  # number of its subclass markers so far
    CHAIN,  # row of the POLYLINE whose vertices follow, or -1
    FOLLOWED,  # whether ATTRIBs and a SEQEND follow the open INSERT
    GROUP,  # 1 within {…}, 2 in extension data
    IS_MTEXT,
    TABLE,  # keyword of the open table, 0 before its name, -1 for none
    NAMED,  # whether the open row of the table has a name
    ENTITIES,
    VERTICES,
    BLOCKS,
    LAYERS,
    NAMES,
    UNSURES,  # decimals that are left to ``float``
    OTHERS,  # handles of other objects
    MOST_ENTITIES,  # first row of the next part of the file
    MOST_VERTICES,
    MOST_OTHERS,
    HEADER_FIRST,
    HEADER_LAST,
) = range(27)
STATES: Final = 27
# Values of MODE: the structure that contains the current tag.
(
    NOTHING, IN_SECTION, IN_TABLE, IN_LAYER, IN_STYLE, IN_ROW, IN_OBJECTS, IN_BLOCK, IN_ENTITY,
    IN_VERTEX,
) = range(10)  # fmt: skip
# Results of the scan.
ON, DONE, REFUSED = range(3)
