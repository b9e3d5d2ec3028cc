"""value_types: the type of the value of each DXF group code."""

from __future__ import annotations

from typing import Final

import numpy as np

TEXT_VALUE, DECIMAL, INTEGER, HEX = range(4)
LAST_CODE: Final = 1071
#: Type of the value by group code ("Group Code Value Types" in the DXF reference), shape (1072,).
TYPE: Final = np.full(LAST_CODE + 1, TEXT_VALUE)
for _type, _ranges in (
    (DECIMAL, ((10, 59), (110, 149), (210, 239), (460, 469), (1010, 1059))),
    (INTEGER, ((60, 79), (90, 99), (160, 179), (270, 299), (370, 389), (400, 409), (420, 429),
               (440, 459), (1060, 1071))),
    (HEX, ((310, 319), (1004, 1004))),
):  # fmt: skip
    for _first, _last in _ranges:
        TYPE[_first : _last + 1] = _type
