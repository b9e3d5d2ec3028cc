"""HTTP status of the answer to an error."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from knifetip import errors

#: HTTP status of each error class; subclasses inherit it.
_STATUS: Final[Mapping[type[errors.KnifetipError], int]] = {
    errors.KnifetipError: 422,
    errors.DrawingTooLarge: 413,
    errors.OpenQuestions: 409,
    errors.JobError: 409,
    errors.NotFound: 404,
    errors.KeyReused: 422,
    errors.UnsupportedMedia: 415,
    errors.StaleVersion: 412,
    errors.StoreError: 503,
    errors.ServerBusy: 503,
    errors.AccessDenied: 403,
    errors.SignInRefused: 401,
    errors.SignInSlowDown: 429,
    errors.ControllerError: 502,
}


def status_of(error: errors.KnifetipError) -> int:
    """Return the HTTP status of the class of an error."""
    return next(_STATUS[kind] for kind in type(error).__mro__ if kind in _STATUS)


def answer_status(error: errors.KnifetipError, method: str) -> int:
    """Return the HTTP status of the answer to a request that an error ends."""
    # A name in a body that does not exist has the same status as an id that does not exist.
    unknown = error.message.code == "library.unknown"
    if isinstance(error, errors.LibraryError) and (unknown or method == "GET"):
        return 404
    return status_of(error)
