"""The one main of all harnesses, and what every drawing and every refusal must be.

    python -m tests.fuzz.fuzz_svg FOLDER -max_total_time=600       begin with FOLDER, add to it
    python -m tests.fuzz.fuzz_svg --again FOLDER                   what is in it, as it is shipped

Atheris sees branches of Python only, and numba compiles none that Atheris has changed: while it
looks, all kernels but those of geometry run as Python, where reading past an end is an error
besides.  ``--again`` runs what was found through the compiled kernels, and needs no Atheris.

What Atheris stumbles over it writes into the current folder, or where ``-artifact_prefix=`` says.
``pip install atheris`` first: it is no dependency of the project.  What is found is kept as a test.
"""

from __future__ import annotations

import importlib
import logging
import pkgutil
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from knifetip import geometry, kernels
from knifetip.errors import KnifetipError
from knifetip.formats.limits import REACH
from knifetip.model.drawing import Drawing

AGAIN = "--again"


@contextmanager
def watched(*packages: str) -> Iterator[None]:
    """Import these packages so that Atheris sees their branches, those of their kernels too."""
    if AGAIN in sys.argv:
        yield
        return
    import atheris

    # Atheris goes by the first part of a name only.  What is imported before, it leaves alone.
    for module in pkgutil.iter_modules(geometry.__path__, "knifetip.geometry."):
        importlib.import_module(module.name)
    decorators = kernels.kernel, kernels.inline_kernel
    kernels.kernel = kernels.inline_kernel = _as_python
    try:
        with atheris.instrument_imports(include=list(packages)):
            yield
    finally:
        kernels.kernel, kernels.inline_kernel = decorators


def _as_python(*function: Any, **_options: Any) -> Any:
    # With the types of a kernel said, it is handed over afterwards.
    return function[0] if function and callable(function[0]) else lambda kernel: kernel


def main(one: Callable[[bytes], object]) -> None:
    """Give ``one`` whatever Atheris thinks of, or what a folder holds."""
    logging.disable(logging.CRITICAL)
    warnings.simplefilter("ignore")
    if AGAIN in sys.argv:
        for path in sorted(Path(sys.argv[-1]).iterdir()):
            try:
                one(path.read_bytes())
            except Exception as error:
                raise SystemExit(f"{path}: {type(error).__name__}: {error}") from error
        return
    import atheris

    atheris.Setup(sys.argv, one)
    atheris.Fuzz()


def read_or_refused(read: Callable[[bytes], Drawing], data: bytes) -> Drawing | None:
    """Return the drawing, or None where it is refused with a reason and a hint.

    Raises
    ------
    AssertionError
        The drawing is unsound, or the refusal does not know what it refuses.
    """
    try:
        drawing = read(data)
    except KnifetipError as error:
        known(error)
        return None
    assert np.isfinite(drawing.ends).all()
    assert (np.abs(drawing.ends) <= 1.001 * REACH).all()
    assert (np.abs(drawing.bulge) <= 1.0).all()
    total = drawing.lengths.sum()
    assert abs(total - drawing.import_report.length.sum()) <= 1e-9 * total + 1e-9
    return drawing


def known(refused: KnifetipError) -> None:
    """Check that a refusal says what to do, and knows what it refuses."""
    assert refused.hint, refused.text
    assert refused.message.code != "reading.unexpected", repr(refused.__cause__)
