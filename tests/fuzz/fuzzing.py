"""The common main function of all fuzz targets.

    python -m tests.fuzz.fuzz_svg FOLDER -max_total_time=600       start with FOLDER, add to it
    python -m tests.fuzz.fuzz_svg --again FOLDER                   run all files in FOLDER

Atheris observes branches of Python code only, and numba cannot compile functions that Atheris has
instrumented.  During fuzzing all kernels except those of ``geometry`` run as Python, in which
reading past the end of an array is an error too.  ``--again`` runs the files in FOLDER with
compiled kernels and does not need Atheris.

Atheris writes failing inputs to the current folder or to ``-artifact_prefix=``.  It is no
dependency of the project: ``pip install atheris`` first.  Keep each finding as a test.
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

from knifetip import geometry, kernels

AGAIN = "--again"


@contextmanager
def instrumented(*packages: str) -> Iterator[None]:
    """Instrument packages that are imported in the context, and run their kernels as Python."""
    if AGAIN in sys.argv:
        yield
        return
    import atheris

    # Atheris selects by top-level package; modules imported before are not instrumented.
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
    # If the decorator has arguments, the kernel is the argument of a second call.
    return function[0] if function and callable(function[0]) else lambda kernel: kernel


def main(target: Callable[[bytes], object]) -> None:
    """Run a fuzz target with inputs from Atheris, or with ``--again`` with the files of a
    folder.
    """
    logging.disable(logging.CRITICAL)
    # The inputs are damaged, and millions of warnings about them would hide a finding.
    warnings.simplefilter("ignore")
    if AGAIN in sys.argv:
        for path in sorted(Path(sys.argv[-1]).iterdir()):
            try:
                target(path.read_bytes())
            except Exception as error:
                raise SystemExit(f"{path}: {type(error).__name__}: {error}") from error
        return
    import atheris

    atheris.Setup(sys.argv, target)
    atheris.Fuzz()
