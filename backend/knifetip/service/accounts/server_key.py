"""The access key of a server, from the command line or from a file."""

from __future__ import annotations

import contextlib
import os
import re
import secrets
from collections.abc import Sequence
from pathlib import Path

from knifetip.errors import SettingsError
from knifetip.service.accounts.access_rules import parse_authority

SHORTEST = 8
_KEY = re.compile(r"[!-~]{8,200}")


def load_key(key: str, file: Path | None) -> str:
    """Return ``key``, or the key in ``file``; "" if neither is given.

    Raises
    ------
    SettingsError
        Both ``key`` and ``file`` are given, the key is malformed, or the file cannot be used.
    """
    if key and file is not None:
        raise SettingsError("settings.two-keys")
    if file is not None:
        return _read_key(file)
    return _check(key, "The key") if key else ""


def _read_key(file: Path) -> str:
    """Return the key in a file.

    A file that does not exist is created with a random key, readable by its owner only.
    """
    try:
        with contextlib.suppress(FileExistsError):
            file.parent.mkdir(parents=True, exist_ok=True)
            descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with open(descriptor, "w", encoding="ascii") as stream:
                stream.write(secrets.token_urlsafe(24) + "\n")
        text = file.read_text("ascii").strip()
    except (OSError, UnicodeDecodeError) as reason:
        raise SettingsError("settings.key-file", file=file, reason=reason) from reason
    return _check(text, f"The key in {file}")


def _check(key: str, origin: str) -> str:
    if _KEY.fullmatch(key) is None:
        raise SettingsError("settings.bad-key", what=origin, shortest=SHORTEST, length=len(key))
    return key


def check_hosts(hosts: Sequence[str]) -> tuple[str, ...]:
    """Return the host names as a tuple; each must have the form NAME or NAME:PORT.

    Raises
    ------
    SettingsError
        A host name has another form.
    """
    for host in hosts:
        if parse_authority(host) is None:
            raise SettingsError("settings.bad-host", host=host[:100])
    return tuple(hosts)
