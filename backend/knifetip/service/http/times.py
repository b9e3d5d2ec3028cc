"""Times in RFC 3339, as the REST API sends and accepts them.

Within the program, times are seconds since 1970-01-01 UTC.  The API sends them in UTC with
milliseconds, ``2030-01-02T03:04:05.123Z``, and accepts any offset.
"""

from __future__ import annotations

import re
from datetime import UTC, datetime
from typing import Annotated, Any, Final

from pydantic import BeforeValidator, WithJsonSchema, model_validator

from knifetip.fields import field_error
from knifetip.service.http.time_text import rfc3339 as rfc3339

_EPOCH: Final = datetime(1970, 1, 1, tzinfo=UTC)
#: Begin of the year 1 and end of the year 9999 in UTC, beyond which no time can be sent back.
_FIRST: Final = -62_135_596_800.0
_END: Final = 253_402_300_800.0
_TEXT: Final = re.compile(
    r"(\d{4})-(\d\d)-(\d\d)[Tt ](\d\d):(\d\d):(\d\d)(\.\d{1,60})?(?:[Zz]|([+-])(\d\d):(\d\d))",
    re.ASCII,
)
_SCHEMA: Final = WithJsonSchema(
    {"type": "string", "format": "date-time", "examples": ["2030-01-02T03:04:05.123Z"]}
)


def seconds_of(text: str) -> float | None:
    """Return the seconds since 1970 of a time in RFC 3339, or None if the text is none.

    A leap second counts as the first second of the next minute.
    """
    match = _TEXT.fullmatch(text)
    if match is None:
        return None
    year, month, day, hour, minute, second = (int(part) for part in match.groups()[:6])
    sign, hours, minutes = match[8] or "+", int(match[9] or 0), int(match[10] or 0)
    if second > 60 or hours > 23 or minutes > 59:
        return None
    try:
        begin = datetime(year, month, day, hour, minute, tzinfo=UTC)
    except ValueError:
        return None
    offset = (hours * 3600 + minutes * 60) * (-1 if sign == "-" else 1)
    return (begin - _EPOCH).total_seconds() + second + float(match[7] or 0.0) - offset


def _shown(value: Any) -> Any:
    return rfc3339(value) if isinstance(value, int | float) else value


def _accepts(value: Any) -> float:
    found = seconds_of(value) if isinstance(value, str) else None
    if found is None:
        raise field_error("field.not-a-time")
    if not _FIRST <= found < _END:
        raise field_error("field.no-year")
    return found


def in_order(*pairs: tuple[str, str]) -> Any:
    """Return a validator of a pydantic model: the second time of a pair is not before the first.

    The pairs contain names of fields with times in seconds since 1970, or None.
    """

    def check(model: Any) -> Any:
        for first, second in pairs:
            begin, end = getattr(model, first), getattr(model, second)
            if begin is not None and end is not None and end < begin:
                raise field_error("field.wrong-order", first=first, second=second)
        return model

    return model_validator(mode="after")(check)


#: A time in an answer.
Moment = Annotated[str, BeforeValidator(_shown), _SCHEMA]
#: A time in an answer that may be missing: stored as 0, sent as null.
OptionalMoment = Annotated[Moment | None, BeforeValidator(lambda value: value or None)]
#: A time in a request; the value of the field is in seconds since 1970.
MomentIn = Annotated[float, BeforeValidator(_accepts), _SCHEMA]
