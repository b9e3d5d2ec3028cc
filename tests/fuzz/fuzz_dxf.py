"""Fuzz the readers of DXF: any bytes give a Drawing or a KnifetipError.

If both readers return a drawing, the two must be equal bit by bit.  The fast reader falls back to
ezdxf for unsupported input and raises no other exception.  See ``fuzzing`` for how to run it.
"""

from __future__ import annotations

import traceback

from tests.fuzz.fuzzing import instrumented, main

with instrumented("knifetip.dxf", "ezdxf"):
    from knifetip.errors import KnifetipError
    from tests.support.truth.readers import difference, read_by_both


def run_input(data: bytes) -> None:
    """Read the data with both readers and compare the results."""
    ours, reference = read_by_both(data)
    if isinstance(ours, KnifetipError) and ours.__cause__ is not None:
        # Unexpected exceptions may come from ezdxf only.
        frames = [frame.name for frame in traceback.extract_tb(ours.__cause__.__traceback__)]
        assert "read_fast" not in frames, repr(ours.__cause__)
    if isinstance(ours, KnifetipError) or isinstance(reference, KnifetipError):
        return
    if differences := difference(ours, reference):
        raise AssertionError(differences)


if __name__ == "__main__":
    main(run_input)
