"""Answers to requests with an Idempotency-Key, so that none of them is executed twice.

A request is stored before it is executed.  If the server dies in between, its outcome is not known,
and a repetition is refused: it may have moved a machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError

from knifetip.service.database.engine import Database
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import AnsweredRequest

#: Time (s) for which an answer is kept.
KEPT: Final = 7 * 86_400.0


class AnsweredRequests:
    """Repository of requests with an Idempotency-Key, and of their answers."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def begin(self, key: RequestKey) -> AnsweredRequest | None:
        """Store a request that is about to be executed, or return the one with the same key.

        Raises
        ------
        KeyReused
            The key was used for another request.
        """
        now = self._db.clock()
        row = AnsweredRequest(
            key=key.stored,
            fingerprint=key.fingerprint,
            created=now,
            status=0,
            headers={},
            body=b"",
        )
        try:
            with self._db.writing() as session:
                old = AnsweredRequest.created < now - KEPT
                session.execute(sa.delete(AnsweredRequest).where(old))
                session.add(row)
        except IntegrityError:
            with self._db.reading() as session:
                earlier = session.get(AnsweredRequest, key.stored)
            if earlier is None:
                raise
            return key.check(earlier)
        return None

    def end(self, key: RequestKey, status: int, headers: Mapping[str, str], body: bytes) -> None:
        """Store the answer to a request."""
        answer = {"status": status, "headers": dict(headers), "body": body}
        with self._db.writing() as session:
            session.execute(
                sa.update(AnsweredRequest).where(AnsweredRequest.key == key.stored).values(**answer)
            )

    def forget(self, key: RequestKey) -> None:
        """Delete a request that was refused, so that a repetition is executed."""
        with self._db.writing() as session:
            session.execute(sa.delete(AnsweredRequest).where(AnsweredRequest.key == key.stored))
