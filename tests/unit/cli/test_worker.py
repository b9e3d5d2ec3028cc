"""A stuck compile worker exits with an error, so that its service manager restarts it."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

_RUN = """
from knifetip.cli import service
from knifetip.cli.main import main
from knifetip.service.compiling.service import CompileService

service._LOOK = 0.05
CompileService.seconds_since_sweep = {silent}
main()
"""


@contextmanager
def worker(folder: Path, silent: float) -> Iterator[subprocess.Popen[str]]:
    """Run a worker which always reports that its last sweep was ``silent`` seconds ago."""
    words = ("worker", "--database", f"sqlite:///{folder}/a.sqlite", "--migrate")
    code = _RUN.format(silent=silent)
    process = subprocess.Popen(
        [sys.executable, "-c", code, *words], stderr=subprocess.PIPE, text=True
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def test_a_worker_that_is_stuck_ends_with_an_error(tmp_path: Path) -> None:
    with worker(tmp_path, 301.0) as process:
        _, text = process.communicate(timeout=120.0)
    assert process.returncode == 1
    assert "has not looked for jobs for 301 s" in text


def test_a_worker_that_sweeps_goes_on_until_it_is_stopped(tmp_path: Path) -> None:
    with worker(tmp_path, 299.0) as process:
        assert process.stderr is not None
        for line in process.stderr:
            if "compile worker for" in line:
                break
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(1.0)
        process.terminate()
        _, text = process.communicate(timeout=120.0)
    assert process.returncode in {0, 143}
    assert "stuck" not in text
