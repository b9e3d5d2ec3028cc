"""Keys of requests: a client that repeats a request with its key gets the result of the first."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from typing import TypeVar

from knifetip.errors import KeyReused
from knifetip.service.database.acting import acting_principal
from knifetip.service.database.engine import short
from knifetip.service.database.tables import AnsweredRequest, CommandKey, Drawing, Job

Row = TypeVar("Row", Drawing, Job, CommandKey, AnsweredRequest)


@dataclass(frozen=True, slots=True)
class RequestKey:
    """Idempotency-Key of a request, and a hash of the content of the request.

    A key belongs to the principal that sent it: the same text of another one is another key.
    """

    text: str  #: the key: a text that the client sends again if it repeats the request
    fingerprint: str  #: hash of the content of the request
    principal: str = field(default_factory=acting_principal)  #: sender of the request

    @property
    def stored(self) -> str:
        """Text in the database; it is different for each pair of principal and key."""
        # The principal has no zero character, so that two pairs never give the same text.
        return hashlib.sha256(f"{self.principal}\0{self.text}".encode()).hexdigest()

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


def fingerprint(*parts: str | bytes) -> str:
    """Return a SHA-256 hash of the contents of a request, in hexadecimal digits.

    The contents are the positional arguments, texts or bytes.  The hash shows whether two requests
    with the same Idempotency-Key are equal.
    """
    digest = hashlib.sha256()
    for part in parts:
        block = part.encode("utf-8", "replace") if isinstance(part, str) else part
        digest.update(len(block).to_bytes(8, "big") + block)
    return digest.hexdigest()
