"""queue_selection: select the kind of compile queue for a database.

With PostgreSQL, several processes may compile, so each compile is a durable workflow.  With SQLite,
the table of jobs is sufficient.
"""

from __future__ import annotations

from knifetip.jobs.compile_queue import CompileQueue, FractionCompiled, TableQueue
from knifetip.jobs.store import Store


def select_queue(
    store: Store,
    worker: str,
    at_once: int,
    poll: float = 1.0,
    *,
    fraction_compiled: FractionCompiled = lambda _machine: 1.0,
) -> CompileQueue:
    """Return the compile queue for the database of a store.

    Parameters
    ----------
    store
        Store that contains the jobs.
    worker
        Name of the worker that becomes the owner of each job taken.
    at_once
        Number of jobs that are compiled at the same time.
    poll
        Time between two queries for jobs that another process received (s), if that process
        does not notify this one.
    fraction_compiled
        Function that takes the name of a machine and returns a fraction (0 … 1): the part of the
        numba functions for compiling jobs for this machine that has machine code.
    """
    table = TableQueue(store, worker, at_once, poll, fraction_compiled)
    if store.database.url.startswith("postgresql"):
        from knifetip.jobs.durable_queue import DurableQueue  # imports DBOS, which needs 24 MB

        return DurableQueue(store, worker, table)
    return table
