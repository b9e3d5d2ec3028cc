"""queue_selection: select the kind of compile queue for a database.

With PostgreSQL, several processes may compile, so each compile is a durable workflow.  With SQLite,
the table of jobs is sufficient.
"""

from __future__ import annotations

from knifetip.service.compiling.queue import CompileQueue, FractionCompiled, TableQueue
from knifetip.service.store import Store


def select_queue(
    store: Store,
    worker: str,
    at_once: int,
    poll: float = 1.0,
    *,
    fraction_compiled: FractionCompiled = lambda _machine: 1.0,
) -> CompileQueue:
    """Return the compile queue for the database of a store.

    The parameters are those of ``TableQueue``.
    """
    table = TableQueue(store, worker, at_once, poll, fraction_compiled)
    if store.database.url.startswith("postgresql"):
        from knifetip.service.compiling.durable_queue import (
            DurableQueue,  # imports DBOS, which needs 24 MB
        )

        return DurableQueue(store, worker, table)
    return table
