"""customer_unit: the unit of a file that states none, from earlier drawings of its customer."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath

from knifetip.model.customer_answers import LearnedUnit, TaughtDrawing

#: Number of different files whose answers must agree.
_ENOUGH = 2


def learn_unit(taught: Sequence[TaughtDrawing], name: str, sha256: str) -> LearnedUnit | None:
    """Return the unit of a file of a customer that states none; None if it must be asked about.

    The newest two answers for different files of the same kind must agree.  The answer for the same
    file suffices.

    Parameters
    ----------
    taught
        Earlier drawings of the customer, the newest first.
    name, sha256
        Name and SHA-256 of the file.
    """
    kind = PurePath(name).suffix.lower()
    answered = [one for one in taught if one.unit and PurePath(one.name).suffix.lower() == kind]
    for one in answered:
        if one.sha256 == sha256:
            return LearnedUnit(one.unit, (one.name,))
    newest = list({one.sha256: one for one in reversed(answered)}.values())[::-1][:_ENOUGH]
    if len(newest) < _ENOUGH or len({one.unit for one in newest}) > 1:
        return None
    return LearnedUnit(newest[0].unit, tuple(one.name for one in newest))
