"""The examples of README.md run as printed, with a server and a drawing of these tests."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.dxf.samples import samples
from tests.conftest import ROOT
from tests.support.serving.server import Running, wait_for_state

pytestmark = pytest.mark.xdist_group("readme")

PRINTED_SERVER = "localhost:8080"


def examples(heading: str) -> list[str]:
    """Return the code blocks (indented by four spaces) under a heading of README.md."""
    text = (ROOT / "README.md").read_text("utf-8")
    section = re.split(r"^## ", text.split(f"## {heading}\n", 1)[1], maxsplit=1, flags=re.M)[0]
    blocks = re.findall(r"^(?: {4}.*\n(?:\n(?= {4}))?)+", section, re.M)
    return [re.sub(r"^ {4}", "", block, flags=re.M) for block in blocks]


@pytest.fixture
def tray(tmp_path: Path) -> Path:
    """Return a folder that contains the file named in the examples."""
    (tmp_path / "corrugated-tray.dxf").write_bytes(samples()["corrugated-tray.dxf"])
    return tmp_path


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    """Run the whole service on a free port, with a simulated table at 50 times its speed."""
    with Running(tmp_path_factory.mktemp("readme") / "readme.sqlite", speed=50.0) as client:
        yield client


def run_in_shell(commands: str, folder: Path, server: httpx.Client, **variables: str) -> str:
    """Run commands of the README in a shell, in a folder; return the last line that they print.

    The address of the server replaces that in the commands.
    """
    address = f"{server.base_url.host}:{server.base_url.port}"
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", commands.replace(PRINTED_SERVER, address)],
        cwd=folder,
        env={**os.environ, "no_proxy": "*", **variables},
        capture_output=True,
        text=True,
        timeout=120.0,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip().splitlines()[-1]


def job_that_waits(server: httpx.Client, job: str) -> dict[str, Any]:
    """Wait until a job waits for the operator's confirmation; return the job."""
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        found: dict[str, Any] = server.get(f"/api/jobs/{job}").json()
        if found["waiting_for"] == "confirmation":
            return found
        time.sleep(0.05)
    raise AssertionError(f"job {job} does not wait for its confirmation: {found}")


def test_the_python_example_compiles_an_accepted_program(tray: Path) -> None:
    (code,) = examples("From Python")
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tray, capture_output=True, text=True, timeout=240.0,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("True ")
    program = (tray / "tray.ngc").read_bytes()
    assert program.endswith(b"M2\n") or program.endswith(b"M30\n")


@pytest.mark.skipif(
    not (shutil.which("curl") and shutil.which("jq")), reason="the examples call curl and jq"
)
def test_the_curl_examples_order_watch_and_confirm_a_job(tray: Path, server: httpx.Client) -> None:
    found = re.fullmatch(
        r"(id=.*?\njob=.*?)(curl -N \S+)[^\n]*\n(curl .*?/confirmation)[^\n]*\n(curl .*?)\n",
        examples("Over REST")[0],
        re.DOTALL,
    )
    assert found is not None
    order, watch, ask, confirm = found.groups()
    job = run_in_shell(f"{order}\necho $job", tray, server)
    job_that_waits(server, job)
    # The stream of events does not end: it is read for two seconds.
    events = run_in_shell(f"{watch} --max-time 2 || [ $? = 28 ]; echo read", tray, server)
    assert events == "read"
    assert "hands-clear" in run_in_shell(ask, tray, server, job=job)
    confirmed = run_in_shell(confirm, tray, server, job=job)
    assert job in confirmed
    assert wait_for_state(server, job, "done")["copies_done"] == 1


@pytest.mark.skipif(not shutil.which("curl"), reason="the example calls curl")
def test_the_first_curl_example_uploads_a_drawing_in_millimetres(
    tray: Path, server: httpx.Client
) -> None:
    text = (ROOT / "README.md").read_text("utf-8")
    (command,) = re.findall(r"^ {4}(curl -F file=\S+ -F unit=mm \S+)", text, re.M)
    answer = run_in_shell(command, tray, server)
    assert '"unit":"mm"' in answer
