"""passwords: hashes of passwords by Argon2id (RFC 9106).

The parameters are the second of OWASP's equivalent choices: 19 MiB, 2 passes, 1 lane.
"""

from __future__ import annotations

from typing import Final

from argon2 import PasswordHasher, Type
from argon2.exceptions import InvalidHashError, VerificationError

from knifetip.errors import RequestError
from knifetip.messages import Message
from knifetip.service.accounts.weak_passwords import Weakness, weakness_of

SHORTEST: Final = 10
#: Limits the time of the hash, which grows with the length of the password.
LONGEST: Final = 1000

_REASONS: Final[dict[Weakness, str]] = {
    "blank": "user.password-blank",
    "repeated": "user.password-repeated",
    "sequence": "user.password-sequence",
    "common": "user.password-common",
    "name": "user.password-name",
}
_HASHER: Final = PasswordHasher(
    time_cost=2, memory_cost=19456, parallelism=1, hash_len=32, salt_len=16, type=Type.ID
)
#: Hash of a random password that is not kept, for names that no user has.
_NO_USER: Final = (
    "$argon2id$v=19$m=19456,t=2,p=1$XpWcUnuxPltBry7WDX0Jow$"
    "eh3Tp2yWRsupcMlJBZs9XGKPDewRpz8LAWmmLipzAxQ"
)


def check_password(password: str, name: str = "") -> None:
    """Raise ``RequestError`` if a new password is too short, too long or easily guessed."""
    if not SHORTEST <= len(password) <= LONGEST:
        raise RequestError(
            "user.bad-password", shortest=SHORTEST, longest=LONGEST, length=len(password)
        )
    weakness = weakness_of(password, name)
    if weakness is not None:
        raise RequestError("user.weak-password", why=Message(_REASONS[weakness]))


def hash_password(password: str) -> str:
    """Return the Argon2id hash of a password, with its random salt and its parameters."""
    return _HASHER.hash(password)


def is_password(password: str, stored: str | None) -> bool:
    """Return whether a password has a stored hash; this takes the same time for every password.

    Parameters
    ----------
    password
        The password.
    stored
        Its hash; None if there is no such user, which takes the same time and is never right.
    """
    if len(password) > LONGEST:
        return False
    try:
        _HASHER.verify(stored or _NO_USER, password)
    except (VerificationError, InvalidHashError):
        return False
    return bool(stored)


def is_outdated(stored: str) -> bool:
    """Return whether a hash was made with other parameters than new hashes."""
    return _HASHER.check_needs_rehash(stored)
