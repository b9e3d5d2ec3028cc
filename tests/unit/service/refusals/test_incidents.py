"""The log has an unexpected exception under a number, which is all that the answer has."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.service.processes import tasks
from knifetip.service.settings import Settings
from tests.support.serving import crew_tasks
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)

#: What Python says about the exception of ``crew_tasks.fail``.
PYTHON = ("Error", "one by none", "division", "Traceback")


@pytest.fixture
def server(tmp_path: Path) -> Iterator[LocalClient]:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", compiles=True)) as client:
        yield client


def let_fail(server: LocalClient, patch: pytest.MonkeyPatch, task: Callable[..., Any]) -> None:
    """Let an exception be raised in the worker process in place of a task."""
    pool = server.service.pool
    execute = pool.run

    def run(wanted: Callable[..., Any], *arguments: object, **options: Any) -> Any:
        if wanted is task:
            return execute(crew_tasks.fail, **options)
        return execute(wanted, *arguments, **options)

    patch.setattr(pool, "run", run)


def check(message: dict[str, Any], code: str, log: str) -> None:
    """Check that a message has the number of an entry in the log, and no words of Python."""
    assert message["code"] == code
    incident = message["arguments"]["incident"]
    assert len(incident) == 8
    assert incident in message["text"]
    assert f"error {incident}: a task failed" in log
    assert "one by none" in log
    assert not any(word in message["text"] + message["hint"] for word in PYTHON)


def test_a_file_whose_reader_fails(
    server: LocalClient, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    let_fail(server, monkeypatch, tasks.read)
    with caplog.at_level(logging.ERROR):
        answer: httpx.Response = server.post(
            "/api/drawings", files={"file": ("tray.dxf", square())}
        )
    assert answer.status_code == 422
    check(answer.json(), "reading.crashed", caplog.text)


def test_a_job_whose_compile_fails(
    server: LocalClient, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    drawing = upload_drawing(server, square())["id"]
    let_fail(server, monkeypatch, tasks.compile)
    with caplog.at_level(logging.ERROR):
        job = order_job(server, drawing, machine="demo-table")["id"]
        row = wait_for_state(server, job, "refused")
    check(row["message"], "job.compile-crashed", caplog.text)
