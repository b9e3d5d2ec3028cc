"""audit_store: repository of the audit log; entries are only appended."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sqlalchemy as sa

from knifetip.service.database.account_tables import AuditEntry
from knifetip.service.database.acting import ActingPrincipal
from knifetip.service.database.engine import Database


@dataclass(frozen=True, slots=True)
class AuditFilter:
    """Conditions on entries of the audit log; an empty one permits all entries."""

    principal: str = ""
    action: str = ""
    subject: str = ""
    outcome: str = ""
    since: float | None = None  #: seconds since 1970
    until: float | None = None  #: seconds since 1970


class AuditStore:
    """Repository of the audit log."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def write(self, acting: ActingPrincipal, outcome: str) -> None:
        """Write the entry of a request that has stored nothing else."""
        # Set first: otherwise this transaction, too, would add an entry for its request.
        acting.written = True
        with self._db.writing() as session:
            session.add(acting.entry(self._db.clock(), outcome))

    def search(
        self, wanted: AuditFilter, before: int | None = None, limit: int = 100
    ) -> Sequence[AuditEntry]:
        """Return entries, the newest first.

        Parameters
        ----------
        wanted
            Conditions on the entries.
        before
            Only entries with a smaller id; None for all.
        limit
            Greatest number of entries.
        """
        query = sa.select(AuditEntry)
        for column in ("principal", "action", "subject", "outcome"):
            value = getattr(wanted, column)
            if value:
                query = query.where(getattr(AuditEntry, column) == value)
        if wanted.since is not None:
            query = query.where(AuditEntry.at >= wanted.since)
        if wanted.until is not None:
            query = query.where(AuditEntry.at < wanted.until)
        if before is not None:
            query = query.where(AuditEntry.id < before)
        with self._db.reading() as session:
            return list(session.scalars(query.order_by(AuditEntry.id.desc()).limit(limit)))
