"""The readers of DXF: no bytes may end in anything but a Drawing or a KnifetipError.

Where both readers give a drawing, it must be the same to the bit; and what our own reader does not
expect, it hands over and does not stumble over.  How to run it: see ``fuzzing``.
"""

from __future__ import annotations

import traceback

from tests.fuzz.fuzzing import main, watched

with watched("knifetip.dxf", "ezdxf"):
    from knifetip.errors import KnifetipError
    from tests.support.truth.readers import difference, read_by_both


def one(data: bytes) -> None:
    """Read by both, and compare."""
    ours, reference = read_by_both(data)
    if isinstance(ours, KnifetipError) and ours.__cause__ is not None:
        # Only what ezdxf does with hostile bytes may surprise.
        frames = [frame.name for frame in traceback.extract_tb(ours.__cause__.__traceback__)]
        assert "read_fast" not in frames, repr(ours.__cause__)
    if isinstance(ours, KnifetipError) or isinstance(reference, KnifetipError):
        return
    if said := difference(ours, reference):
        raise AssertionError(said)


if __name__ == "__main__":
    main(one)
