"""From bytes to classified and cleaned edges, as the server does it; the first byte chooses a unit.

How to run it: see ``fuzzing``.
"""

from __future__ import annotations

from tests.fuzz.fuzzing import known, main, watched

with watched("knifetip.units", "knifetip.classification", "knifetip.cleaning", "knifetip.jobs"):
    from knifetip.errors import KnifetipError
    from knifetip.jobs import tasks
    from knifetip.model.interpretation import Interpretation

_UNITS = ("", "mm", "in", "m")


def one(data: bytes) -> None:
    """Read, classify, ask and clean."""
    unit = _UNITS[data[0] % len(_UNITS)] if data else ""
    try:
        reading = tasks.read(lambda _stage, _share: None, data[1:], Interpretation(unit))
    except KnifetipError as error:
        known(error)
        return
    if reading.summary["unit"]:
        tasks.cleaning_report(lambda _stage, _share: None, reading.edges)


if __name__ == "__main__":
    main(one)
