"""Tests of a group or module run in one worker, those that take long first.

pytest 9.2 and pytest-xdist 3.8 ignored the groups.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support.scheduling import LONGEST, rank

TESTS = Path(__file__).parents[2]


@pytest.mark.xdist_group("one-worker")
@pytest.mark.parametrize("number", range(6))
def test_the_tests_of_a_group_run_in_one_worker(
    number: int, worker_id: str, testrun_uid: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    assert_only_worker(worker_id, tmp_path_factory, f"group-{testrun_uid}")


@pytest.mark.parametrize("number", range(6))
def test_the_tests_of_a_module_run_in_one_worker(
    number: int, worker_id: str, testrun_uid: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    assert_only_worker(worker_id, tmp_path_factory, f"module-{testrun_uid}")


def assert_only_worker(worker: str, temporary: pytest.TempPathFactory, name: str) -> None:
    workers = temporary.getbasetemp().parent / f"workers-{name}"
    workers.mkdir(exist_ok=True)
    (workers / worker).touch()
    assert [path.name for path in workers.iterdir()] == [worker]


def test_groups_run_first_and_short_modules_last() -> None:
    order = [
        "linuxcnc",
        "browser",
        "wheel",
        "tests/integration/test_mutation.py",
        "tests/unit/svg/test_paths.py",
    ]
    ranks = [rank(name) for name in order]
    assert ranks == sorted(set(ranks))
    assert rank("tests/unit/service/jobs/test_store.py") == rank(order[3])


def test_the_groups_that_take_longest_exist() -> None:
    texts = [file.read_text() for file in TESTS.rglob("test_*.py")]
    named = {name for text in texts for name in re.findall(r'xdist_group\("([\w-]+)"\)', text)}
    assert set(LONGEST) <= named
