"""pairing_store: repository of the browsers that are paired with machines, such as tablets at them.

An administrator makes a code for a machine.  Who enters it in a browser pairs that browser: it gets
a key with the scope ``station`` for this machine alone, which is kept in a cookie and is accepted
from no other place.  A code is for one browser, and for some minutes; only its hash is stored.
"""

from __future__ import annotations

import hashlib
import re
import secrets
from collections.abc import Sequence
from typing import Final

import sqlalchemy as sa

from knifetip.contract.job import new_id
from knifetip.harmless import harmless
from knifetip.service.accounts.key_store import new_secret, secret_digest
from knifetip.service.database.account_tables import ApiKey, PairingCode
from knifetip.service.database.acting import set_subject
from knifetip.service.database.engine import Database
from knifetip.service.http.scopes import AccessScope

#: Time for which a code can be used (s).
CODE_LIFETIME: Final = 600.0
#: Time after which a browser is paired anew (s); browsers keep no cookie for much longer.
DEVICE_LIFETIME: Final = 365 * 24 * 3600.0
#: Digits and letters that are not mistaken for one another: 8 of them are 39 random bits.
_CHARACTERS: Final = "23456789ABCDEFGHJKMNPQRSTVWXYZ"
CODE_LENGTH: Final = 8
_NOT_CODE: Final = re.compile(r"[^0-9A-Z]")


class PairingStore:
    """Repository of pairing codes and paired devices."""

    def __init__(self, database: Database) -> None:
        self._db = database

    def new_code(self, machine: str, by: str = "") -> tuple[str, float]:
        """Store a new code for a machine; return it with its end (seconds since 1970)."""
        code = "".join(secrets.choice(_CHARACTERS) for _ in range(CODE_LENGTH))
        now = self._db.clock()
        expires = now + CODE_LIFETIME
        row = PairingCode(
            digest=_digest(code), machine=machine, created_by=by[:200], expires=expires
        )
        with self._db.writing() as session:
            set_subject(session, "machine", machine)
            session.execute(sa.delete(PairingCode).where(PairingCode.expires <= now))
            session.add(row)
        return code, expires

    def pair(self, code: str, title: str = "") -> tuple[ApiKey, str] | None:
        """Use up a pairing code; return the key of the new device with its secret.

        The result is None if there is no such code, or if it has expired or was used.

        Parameters
        ----------
        code
            The code, in small or capital letters, also with spaces and hyphens.
        title
            Name of the device; "" for a name made of that of the machine.
        """
        now = self._db.clock()
        with self._db.writing() as session:
            found = session.get(PairingCode, _digest(code), with_for_update=True)
            if found is None:
                return None
            session.delete(found)
            if found.expires <= now:
                return None
            id = new_id()
            secret = new_secret(id)
            row = ApiKey(
                id=id,
                title=harmless(title).strip()[:100] or f"Device at {found.machine}"[:100],
                digest=secret_digest(secret),
                scopes=[AccessScope.STATION.value],
                customer="",
                machines=[found.machine],
                any_machine=False,
                device=True,
                created=now,
                created_by=found.created_by,
                expires=now + DEVICE_LIFETIME,
                used=None,
                revoked=None,
            )
            set_subject(session, "key", id)
            session.add(row)
            return row, secret

    def devices(self, machine: str) -> Sequence[ApiKey]:
        """Return the devices that are paired with a machine, the newest first."""
        query = (
            sa.select(ApiKey)
            .where(ApiKey.device.is_(True), ApiKey.revoked.is_(None))
            .where(ApiKey.expires > self._db.clock())
            .order_by(ApiKey.created.desc(), ApiKey.id)
        )
        with self._db.reading() as session:
            return [row for row in session.scalars(query) if machine in row.machines]


def shown_code(code: str) -> str:
    """Return a code in two groups, as it is read aloud and typed."""
    half = CODE_LENGTH // 2
    return f"{code[:half]}-{code[half:]}"


def _digest(code: str) -> str:
    plain = _NOT_CODE.sub("", code.upper())
    return hashlib.sha256(plain.encode()).hexdigest()
