"""refusals: what every reader refuses in the same way, before, while and after it reads a file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

import numpy as np

from knifetip.errors import KnifetipError, NotADrawing
from knifetip.formats.limits import Limits
from knifetip.model.unit import factor

#: Errors that damaged numbers and references of a file may cause in a reader.
DAMAGE: Final = (ValueError, ArithmeticError, LookupError)


@contextmanager
def refuse_unexpected(
    data: bytes,
    unit: str | None,
    limits: Limits,
    format_name: str,
    unexpected: tuple[type[Exception], ...] = DAMAGE,
) -> Iterator[None]:
    """Read a file in the body of the ``with`` statement; no file may cause a traceback.

    Numpy warnings about infinite and undefined numbers are off in the body.

    Parameters
    ----------
    data
        Content of the file.
    unit
        The unit that the user gives; None or "" if the user gives no unit.
    limits
        Limits of the size of the file.
    format_name
        Name of the file format in error messages.
    unexpected
        Errors of the body that refuse the file.

    Raises
    ------
    NotADrawing
        The body has raised one of the unexpected errors.
    DrawingTooLarge
        The file is too large.
    NoSuchUnit
        ``unit`` is not a unit.
    """
    factor(unit or "")
    limits.admit(len(data))
    try:
        with np.errstate(all="ignore"):
            yield
    except KnifetipError:
        raise
    except unexpected as error:
        raise NotADrawing(
            "reading.unexpected", reason=type(error).__name__, format=format_name
        ) from error
