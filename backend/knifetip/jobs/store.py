"""store: the database of drawings, profiles, jobs and their events, in SQLite or PostgreSQL.

"sqlite:///knifetip.sqlite" -> Store

Every move of a job is one UPDATE … WHERE state = … in one transaction with the event that records
it.  Two who want the same job, or two jobs that want the same table, are parted by the database:
by that WHERE, by the job's epoch, and by a unique index on the machine of the jobs on a table.
"""

from __future__ import annotations

from knifetip.jobs.compiles import ATTEMPTS, Result
from knifetip.jobs.database import dialect_url
from knifetip.jobs.drawings import Drawings
from knifetip.jobs.moves import LEASE
from knifetip.jobs.profiles import Profiles
from knifetip.jobs.tableside import Queue, Report, Tableside

__all__ = ["ATTEMPTS", "LEASE", "Queue", "Report", "Result", "Store", "dialect_url"]


class Store(Drawings, Profiles, Tableside):
    """The database; safe to use from many threads and from many processes."""
