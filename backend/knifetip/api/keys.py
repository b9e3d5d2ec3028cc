"""keys: the key that a server on the network asks for, given or kept in a file."""

from __future__ import annotations

import contextlib
import os
import re
import secrets
from collections.abc import Sequence
from pathlib import Path

from knifetip.api.access import authority
from knifetip.errors import SettingsError

SHORTEST = 8
_KEY = re.compile(r"[!-~]{8,200}")


def chosen(key: str, file: Path | None) -> str:
    """Return the key that was given, or that of the file; empty where neither is named.

    Raises
    ------
    SettingsError
        Both are named, the key is no key, or the file cannot be used.
    """
    if key and file is not None:
        raise SettingsError("settings.two-keys")
    if file is not None:
        return _kept(file)
    return _checked(key, "The key") if key else ""


def _kept(file: Path) -> str:
    """Return the key of a file; make it with a random one, readable by its owner only."""
    try:
        with contextlib.suppress(FileExistsError):
            file.parent.mkdir(parents=True, exist_ok=True)
            made = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with open(made, "w", encoding="ascii") as stream:
                stream.write(secrets.token_urlsafe(24) + "\n")
        text = file.read_text("ascii").strip()
    except (OSError, UnicodeDecodeError) as reason:
        raise SettingsError("settings.key-file", file=file, reason=reason) from reason
    return _checked(text, f"The key in {file}")


def _checked(key: str, what: str) -> str:
    if _KEY.fullmatch(key) is None:
        raise SettingsError("settings.bad-key", what=what, shortest=SHORTEST, length=len(key))
    return key


def checked_hosts(hosts: Sequence[str]) -> tuple[str, ...]:
    """Return host names, as they were given.

    Raises
    ------
    SettingsError
        One of them is not of the form NAME or NAME:PORT.
    """
    for host in hosts:
        if authority(host) is None:
            raise SettingsError("settings.bad-host", host=host[:100])
    return tuple(hosts)
