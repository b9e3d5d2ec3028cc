"""Keys of requests: a client that repeats a request with its key gets the result of the first."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

from knifetip.errors import KeyReused
from knifetip.jobs.database import short
from knifetip.jobs.tables import CommandKey, Drawing, Job

Row = TypeVar("Row", Drawing, Job, CommandKey)


@dataclass(frozen=True, slots=True)
class RequestKey:
    """Idempotency-Key of a request, and a hash of the content of the request."""

    text: str  #: the key: a text that the client sends again if it repeats the request
    fingerprint: str  #: hash of the content of the request

    def check(self, row: Row) -> Row:
        """Return the drawing, job or command that was stored with this key.

        Raises
        ------
        KeyReused
            It was stored by a request with another content.
        """
        if row.fingerprint != self.fingerprint:
            raise KeyReused("request.key-reused", key=short(self.text))
        return row
