"""Times as text in RFC 3339, as they are sent to other systems."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import Final

_EPOCH: Final = datetime(1970, 1, 1, tzinfo=UTC)
_FIRST: Final = datetime(1, 1, 1, tzinfo=UTC)
_LAST: Final = datetime(9999, 12, 31, 23, 59, 59, 999000, tzinfo=UTC)


def rfc3339(seconds: float) -> str:
    """Return a time (seconds since 1970) as text in UTC with milliseconds, rounded down.

    Times outside the years 1 to 9999 become the first or the last time of them.
    """
    try:
        time = _EPOCH + timedelta(milliseconds=seconds * 1000.0 // 1)
    except OverflowError:
        time = _LAST if seconds > 0.0 else _FIRST
    return time.isoformat(timespec="milliseconds").replace("+00:00", "Z")
