"""The reader of CF2: no bytes may end in anything but a Drawing or a KnifetipError with a hint.

How to run it: see ``fuzzing``.
"""

from __future__ import annotations

from tests.fuzz.fuzzing import main, read_or_refused, watched

with watched("knifetip.cf2", "knifetip.drawing_builder"):
    from knifetip.cf2.read import read
    from knifetip.formats.limits import Limits


LIMITS = Limits(entities=2000, segments=20_000)


def one(data: bytes) -> None:
    """Read, with small limits: what is large is no find."""
    read_or_refused(lambda given: read(given, limits=LIMITS), data)


if __name__ == "__main__":
    main(one)
