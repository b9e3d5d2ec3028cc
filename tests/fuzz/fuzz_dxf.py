"""Atheris on the readers of DXF: no bytes may end in anything but a Drawing or a KnifetipError.

    python -m tests.fuzz.fuzz_dxf FOLDER [-max_total_time=600]

Begins with the files in FOLDER and adds what it finds there.  Where both readers give a drawing,
it must be the same to the bit.  ``pip install atheris`` first: it is no dependency of the project.
What is found is kept as a test (tests/unit/dxf/test_hostile.py).
"""

from __future__ import annotations

import logging
import sys

import atheris

with atheris.instrument_imports(include=["knifetip.dxf", "ezdxf"]):
    from tests.readers import difference, read_by_both

    from knifetip.errors import KnifetipError


def one(data: bytes) -> None:
    """Read by both, and compare."""
    mine, judged = read_by_both(data)
    if isinstance(mine, KnifetipError) or isinstance(judged, KnifetipError):
        return
    if said := difference(mine, judged):
        raise AssertionError(said)


if __name__ == "__main__":
    logging.disable(logging.CRITICAL)
    atheris.Setup(sys.argv, one)
    atheris.Fuzz()
