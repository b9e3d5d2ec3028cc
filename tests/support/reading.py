"""Checks of drawings and refusals that hold for every file."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.testing import assert_allclose

from knifetip.errors import KnifetipError
from knifetip.formats.limits import REACH
from knifetip.model.drawing import Drawing


def read_or_refused(read: Callable[[bytes], Drawing], data: bytes) -> Drawing | None:
    """Return the drawing, or None if the file is refused with a reason and a hint.

    Raises
    ------
    AssertionError
        The drawing is invalid, or the refusal has no hint or hides an unexpected exception.
    """
    try:
        drawing = read(data)
    except KnifetipError as error:
        assert_proper_refusal(error)
        return None
    assert np.isfinite(drawing.ends).all()
    assert (np.abs(drawing.ends) <= 1.001 * REACH).all()
    assert (np.abs(drawing.bulge) <= 1.0).all()
    assert_lengths_add_up(drawing)
    return drawing


def assert_proper_refusal(error: KnifetipError) -> None:
    """Assert that a refusal has a hint and that the reader raised no unexpected exception."""
    assert error.hint, error.text
    assert error.message.code != "reading.unexpected", repr(error.__cause__)


def assert_lengths_add_up(drawing: Drawing) -> None:
    """Assert that each row of the import report has the length of the edges made from it."""
    report = drawing.import_report
    by_row = np.bincount(drawing.entity, drawing.lengths, len(report))
    assert_allclose(by_row, report.length, rtol=1e-9, atol=1e-9)
