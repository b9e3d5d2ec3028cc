"""access_key: the options with which a command names the access key of a server."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from knifetip.errors import SettingsError


@dataclass(frozen=True, slots=True)
class KeyOptions:
    """Options that name the access key of a server: the key, or the file that contains it."""

    key: Annotated[
        str,
        typer.Option(envvar="KNIFETIP_KEY", help="Access key of the server. Default: no key."),
    ] = ""
    key_file: Annotated[
        Path | None,
        typer.Option(
            envvar="KNIFETIP_KEY_FILE",
            help="File that contains the access key, so that it is in no list of processes.",
        ),
    ] = None

    @property
    def headers(self) -> dict[str, str]:
        """Headers of requests to the server.

        Raises
        ------
        SettingsError
            A key and a file are given, or the file cannot be read.
        """
        key = self._read()
        return {"Authorization": f"Bearer {key}"} if key else {}

    def _read(self) -> str:
        if self.key_file is None:
            return self.key
        if self.key:
            raise SettingsError("settings.two-keys")
        try:
            return self.key_file.read_text("ascii").strip()
        except (OSError, UnicodeDecodeError) as reason:
            raise SettingsError("settings.key-file", file=self.key_file, reason=reason) from reason
