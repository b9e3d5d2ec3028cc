"""key_file: files that contain the secrets of API keys."""

from __future__ import annotations

import os
import secrets
from collections.abc import Collection
from contextlib import suppress
from pathlib import Path

from knifetip.errors import SettingsError
from knifetip.service.accounts.key_store import KeyStore
from knifetip.service.database.account_tables import ApiKey
from knifetip.service.database.key_limits import UNLIMITED, KeyLimits
from knifetip.service.http.scopes import AccessScope


def key_in(
    file: Path,
    keys: KeyStore,
    scopes: Collection[AccessScope],
    limits: KeyLimits = UNLIMITED,
) -> ApiKey | None:
    """Return the valid key in a file; None if there is none, or one with other rights.

    Parameters
    ----------
    file
        File with the secret of the key; it need not exist.
    keys
        Repository of the keys.
    scopes
        Scopes that the key must have.
    limits
        Customer and machines that the key must have; no machines for any.
    """
    try:
        secret = file.read_text("ascii").strip()
    except (OSError, UnicodeDecodeError):
        return None
    row = keys.find(secret, used=False)
    if row is None or set(row.scopes) != {scope.value for scope in scopes}:
        return None
    is_for_machines = not limits.machines or limits.machines == frozenset(row.machines)
    return row if row.customer == limits.customer and is_for_machines else None


class NewKeyFile:
    """A file for the secret of a new key, which its owner only can read.

    It is made before the key, so that no key is stored whose secret cannot be written.
    """

    def __init__(self, file: Path) -> None:
        """Make the file, under another name until it contains the secret.

        Raises
        ------
        SettingsError
            The file cannot be made.
        """
        self._file = file
        self._part = file.with_name(f".{file.name}.{secrets.token_hex(4)}")
        try:
            os.close(os.open(self._part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
        except OSError as reason:
            raise SettingsError("settings.key-file", file=file, reason=reason) from reason

    def write(self, secret: str) -> None:
        """Write the secret to a temporary file, which then replaces the key file in one step."""
        with self._part.open("w", encoding="ascii") as stream:
            stream.write(secret + "\n")
            stream.flush()
            os.fsync(stream.fileno())
        self._part.replace(self._file)

    def remove(self) -> None:
        """Remove the temporary file if it has not become the key file."""
        with suppress(FileNotFoundError):  # it got its name
            self._part.unlink()
