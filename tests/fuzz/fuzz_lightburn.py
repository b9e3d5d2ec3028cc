"""Fuzz the reader of LightBurn projects: any bytes give a Drawing or a KnifetipError with a hint.

See ``fuzzing`` for how to run it.
"""

from __future__ import annotations

from tests.fuzz.fuzzing import instrumented, main
from tests.support.reading import read_or_refused

with instrumented("knifetip.lightburn", "knifetip.drawing_builder"):
    from knifetip.formats.limits import Limits
    from knifetip.lightburn.read import read


LIMITS = Limits(entities=2000, segments=20_000)


def run_input(data: bytes) -> None:
    """Read the data with small limits, because large files are no finding."""
    read_or_refused(lambda given: read(given, limits=LIMITS), data)


if __name__ == "__main__":
    main(run_input)
