"""import_notes: rows of an import report that are about the file and not about one entity."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.drawing import ImportOutcome, ImportReport

#: Kind of the rows.
_KIND: Final = "file"


def add_file_notes(report: ImportReport, notes: Sequence[Message]) -> ImportReport:
    """Return an import report with a row at its end for each note about the file.

    The rows have the kind ``file`` and the outcome ``KEPT``, and neither handle, layer nor edges.
    """
    count = len(notes)
    blank = [""] * count
    return replace(
        report,
        handle=[*report.handle, *blank],
        kind=[*report.kind, *[_KIND] * count],
        layer=[*report.layer, *blank],
        outcome=np.append(report.outcome, np.full(count, ImportOutcome.KEPT, np.uint8)),
        reason=[*report.reason, *notes],
        length=np.append(report.length, np.zeros(count)),
        block=[*report.block, *blank] if len(report.block) else (),
    )
