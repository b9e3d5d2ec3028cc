"""logs: one line for each record, as text or JSON, without secrets (ADR 84).

``configure`` sets up the logging of a process.  ``about`` names the request, the job and the
principal to which the records of a context belong.
"""

from __future__ import annotations

import json
import logging
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from datetime import UTC, datetime
from enum import StrEnum
from typing import Final, TextIO

from knifetip.harmless import harmless

#: Attribute of a record with further fields: ``_log.info(text, extra={FIELDS: {…}})``.
FIELDS: Final = "knifetip_fields"
_HIDDEN: Final = "[hidden]"
_NO_FIELDS: Final[Mapping[str, object]] = {}

_context: ContextVar[Mapping[str, object]] = ContextVar("log_fields", default=_NO_FIELDS)

# Ends of names.  Patterns for whole names would be tried at each word of a text, up to its end.
# This takes minutes for a long path of a request, during which no other thread runs.
_NAMES = r"(?:key|token|secret|password|passwd|session|authorization|signature)"
#: What is hidden, with the group that stays visible.
_SECRETS: Final = (
    # Headers and cookies; their values may contain spaces.
    re.compile(
        r"(\b(?:proxy-)?authorization['\"]?\s*[:=]\s*['\"]?(?:bearer|basic)?)[^\r\n,}]+", re.I
    ),
    re.compile(r"(\b(?:set-)?cookie['\"]?\s*[:=]\s*)[^\r\n}]+", re.I),
    re.compile(r"(\b(?:bearer|basic)\s+)[\w.~+/=-]{6,}", re.I),
    # Parameters of URLs and forms, fields of JSON and of records.
    re.compile(rf"({_NAMES}['\"]?\s*[=:]\s*['\"]?)[^\s&'\",;}}]+", re.I),
    # Passwords in URLs of databases and proxies.
    re.compile(r"(://[^\s:/@]{0,256}:)[^\s@]{1,2000}+(?=@)", re.I),
    re.compile(r"(\bwhsec_)[\w+/=-]+"),
    # The id of an API key stays visible.
    re.compile(r"(\bkt_[a-z0-9]{10}_)[\w-]+"),
)
_secrets: set[str] = set()


class LogFormat(StrEnum):
    """How records are written."""

    TEXT = "text"
    JSON = "json"


class LogLevel(StrEnum):
    """The least severe records that are written."""

    DEBUG = "debug"
    INFO = "info"
    WARNING = "warning"
    ERROR = "error"


def hide(secret: str) -> None:
    """Hide a secret in all records of this process from now on; "" hides nothing."""
    if secret:
        _secrets.add(secret)


def without_secrets(text: str) -> str:
    """Return a text in which keys, passwords, cookies and tokens are replaced by "[hidden]"."""
    for secret in _secrets:
        text = text.replace(secret, _HIDDEN)
    for pattern in _SECRETS:
        text = pattern.sub(rf"\1{_HIDDEN}", text)
    return text


@contextmanager
def about(**fields: object) -> Iterator[None]:
    """Add fields, such as ``job``, to all records that are written in this context."""
    token = _context.set({**_context.get(), **fields})
    try:
        yield
    finally:
        _context.reset(token)


def _message(record: logging.LogRecord, formatter: logging.Formatter) -> str:
    """Return the text of a record with the trace of its exception."""
    try:
        text = record.getMessage()
    except (TypeError, ValueError):
        text = f"{record.msg} {record.args}"
    if record.exc_info:
        text += "\n" + formatter.formatException(record.exc_info)
    return text


def _fields(record: logging.LogRecord) -> dict[str, object]:
    return {**_context.get(), **getattr(record, FIELDS, _NO_FIELDS)}


def _time(record: logging.LogRecord) -> str:
    moment = datetime.fromtimestamp(record.created, UTC)
    return moment.isoformat(timespec="milliseconds").replace("+00:00", "Z")


class TextFormatter(logging.Formatter):
    """Formats a record as one line of text."""

    def format(self, record: logging.LogRecord) -> str:
        """Return time, level, logger, message and fields of a record."""
        fields = "".join(f" {name}={value}" for name, value in _fields(record).items())
        text = f"{_message(record, self)}{fields}"
        head = f"{_time(record)} {record.levelname:7} {record.name}: "
        return head + harmless(without_secrets(text))


class JsonFormatter(logging.Formatter):
    """Formats a record as one line of JSON in ASCII."""

    def format(self, record: logging.LogRecord) -> str:
        """Return time, level, logger, message and fields of a record as a JSON object."""
        fields = {
            name: without_secrets(value) if isinstance(value, str) else value
            for name, value in _fields(record).items()
        }
        return json.dumps(
            {
                "time": _time(record),
                "level": record.levelname.lower(),
                "logger": record.name,
                "message": without_secrets(_message(record, self)),
                **fields,
            },
            default=str,
        )


def configure(
    form: LogFormat = LogFormat.TEXT,
    level: LogLevel = LogLevel.WARNING,
    stream: TextIO | None = None,
) -> None:
    """Write the records of all loggers of this process to a stream; None for stderr."""
    handler = logging.StreamHandler(stream or sys.stderr)
    handler.setFormatter(JsonFormatter() if form is LogFormat.JSON else TextFormatter())
    root = logging.getLogger()
    for old in root.handlers[:]:
        root.removeHandler(old)
    root.addHandler(handler)
    root.setLevel(level.upper())
    logging.captureWarnings(True)
    # DBOS adds a handler of its own to a logger that has none.
    logging.getLogger("dbos").addHandler(logging.NullHandler())
    # uvicorn's own configuration, if it was used before, gives these loggers handlers of their own.
    for name in ("uvicorn", "uvicorn.error", "uvicorn.access"):
        logger = logging.getLogger(name)
        logger.handlers.clear()
        logger.propagate = True
    # Libraries that log each of their steps as information.
    for name in ("alembic", "dbos", "httpx", "httpcore", "asyncio"):
        logging.getLogger(name).setLevel(logging.WARNING)
