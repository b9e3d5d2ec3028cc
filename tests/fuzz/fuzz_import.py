"""Fuzz the import: read, classify and clean bytes like the server; the first byte selects a unit.

See ``fuzzing`` for how to run it.
"""

from __future__ import annotations

from tests.fuzz.fuzzing import instrumented, main
from tests.support.reading import assert_proper_refusal

with instrumented(
    "knifetip.units", "knifetip.classification", "knifetip.cleaning", "knifetip.service.processes"
):
    from knifetip.errors import KnifetipError
    from knifetip.model.interpretation import Interpretation
    from knifetip.service.processes import tasks

_UNITS = ("", "mm", "in", "m")


def run_input(data: bytes) -> None:
    """Read and classify the data, list the questions, and clean."""
    unit = _UNITS[data[0] % len(_UNITS)] if data else ""
    try:
        reading = tasks.read(lambda _stage, _share: None, data[1:], Interpretation(unit))
    except KnifetipError as error:
        assert_proper_refusal(error)
        return
    if reading.summary["unit"]:
        tasks.cleaning_report(lambda _stage, _share: None, reading.edges)


if __name__ == "__main__":
    main(run_input)
