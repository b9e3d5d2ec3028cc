"""compiled: how the parts of the pass over a file are compiled."""

from __future__ import annotations

from typing import Final

import numpy as np
from numba import njit

#: A part becomes one piece with the whole: calls with a dozen tables take time.
part: Final = njit(cache=True, error_model="numpy", forceinline=True)

#: A place without a sign takes no time to count from the end; 1 keeps it so.
ONE: Final = np.uint64(1)
