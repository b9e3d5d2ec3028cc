"""All messages of knifetip: code, types of the arguments, text and hint.

There is one module for each area of knifetip, for example ``cleaning`` or ``job``.
"""

from __future__ import annotations

from typing import Final

from knifetip.messages.catalogue import (
    account,
    check,
    classification,
    cleaning,
    compensation,
    content,
    controller,
    corner,
    database,
    drawing,
    dry_run,
    field,
    gateway,
    general,
    geometry,
    grbl,
    hpgl,
    import_outcomes,
    job,
    library,
    limit,
    linuxcnc,
    mcx314,
    motion,
    obstacle,
    operation,
    program,
    queue,
    reading,
    rest,
    rs274,
    server,
    setting,
    sheet,
    unit,
    verification,
    waiting,
    watch,
    webhook,
    xjdf,
)
from knifetip.messages.entry import Entries, Entry

_AREAS: Final = (
    account,
    general,
    geometry,
    reading,
    import_outcomes,
    unit,
    classification,
    cleaning,
    drawing,
    content,
    compensation,
    corner,
    sheet,
    program,
    rs274,
    hpgl,
    verification,
    motion,
    controller,
    setting,
    grbl,
    linuxcnc,
    mcx314,
    gateway,
    operation,
    obstacle,
    dry_run,
    check,
    job,
    database,
    queue,
    rest,
    waiting,
    library,
    field,
    server,
    limit,
    watch,
    webhook,
    xjdf,
)

MESSAGES: Final[Entries] = {code: found for area in _AREAS for code, found in area.MESSAGES.items()}

__all__ = ["MESSAGES", "Entries", "Entry"]
