"""Every kernel is compiled before somebody waits for it: each is in one group of ``warming``."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter

from knifetip import warming
from knifetip.kernels.walk import kernels_of


def test_every_kernel_is_in_exactly_one_group() -> None:
    grouped = [each for names in warming.GROUPS.values() for each in kernels_of(*names)]
    found = list(kernels_of("knifetip"))
    assert len(found) > 200
    assert Counter(grouped) == Counter(found)


def test_the_kernels_of_a_group_are_compiled_with_progress() -> None:
    progress = list(warming.compile_kernels("offsets"))
    total = len(progress)
    assert [each.done for each in progress] == list(range(1, total + 1))
    assert {each.total for each in progress} == {total}
    assert {each.group for each in progress} == {"offsets"}
    assert "geometry.groups.offset_groups" in {each.name for each in progress}
    for each in kernels_of(*warming.GROUPS["offsets"]):
        assert len(each.signatures) == 1, each.py_func


def test_a_group_that_there_is_not_is_refused() -> None:
    asked = [sys.executable, "-m", "knifetip.warming", "gloves"]
    done = subprocess.run(asked, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "drawings, jobs, offsets" in done.stdout
