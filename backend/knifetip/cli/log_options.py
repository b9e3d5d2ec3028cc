"""Options of the commands that run for a long time, for their log."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import typer

from knifetip import logs
from knifetip.logs import LogFormat, LogLevel


@dataclass(frozen=True, slots=True)
class LogOptions:
    """Command-line options for the log on stderr."""

    log_format: Annotated[
        LogFormat,
        typer.Option(
            envvar="KNIFETIP_LOG_FORMAT", help="Form of the log: one line of text or of JSON each."
        ),
    ] = LogFormat.TEXT
    log_level: Annotated[
        LogLevel,
        typer.Option(
            envvar="KNIFETIP_LOG_LEVEL",
            help="Least severe records of the log; info has a record for each request.",
        ),
    ] = LogLevel.WARNING

    def apply(self) -> None:
        """Set up the log of this process."""
        logs.configure(self.log_format, self.log_level)
