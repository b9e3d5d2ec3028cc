"""A compile worker that is stuck ends with an error, so that it is started again."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

_RUN = """
from knifetip.cli import service
from knifetip.cli.main import main
from knifetip.jobs.compile_service import CompileService

service._LOOK = 0.05
CompileService.seconds_since_sweep = {silent}
main()
"""


def worker(folder: Path, silent: float) -> subprocess.Popen[str]:
    """Start a worker whose last sweep always was so many seconds ago."""
    words = ("worker", "--database", f"sqlite:///{folder}/a.sqlite", "--migrate")
    code = _RUN.format(silent=silent)
    return subprocess.Popen([sys.executable, "-c", code, *words], stderr=subprocess.PIPE, text=True)


def test_a_worker_that_is_stuck_ends_with_an_error(tmp_path: Path) -> None:
    _, text = (process := worker(tmp_path, 301.0)).communicate(timeout=120.0)
    assert process.returncode == 1
    assert "no sweep for 301 s" in text


def test_a_worker_that_sweeps_goes_on_until_it_is_stopped(tmp_path: Path) -> None:
    process = worker(tmp_path, 299.0)
    assert process.stderr is not None
    for line in process.stderr:
        if "compile worker for" in line:
            break
    try:
        process.wait(1.0)
    except subprocess.TimeoutExpired:
        process.terminate()
    _, text = process.communicate(timeout=120.0)
    assert process.returncode in {0, 143}
    assert "stuck" not in text
