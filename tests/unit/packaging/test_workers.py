"""Tests of a group run in one worker; pytest 9.2 and pytest-xdist 3.8 ignored the groups."""

from __future__ import annotations

import pytest


@pytest.mark.xdist_group("one-worker")
@pytest.mark.parametrize("number", range(6))
def test_the_tests_of_a_group_run_in_one_worker(
    number: int, worker_id: str, testrun_uid: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    workers = tmp_path_factory.getbasetemp().parent / f"workers-{testrun_uid}"
    workers.mkdir(exist_ok=True)
    (workers / worker_id).touch()
    assert [path.name for path in workers.iterdir()] == [worker_id]
