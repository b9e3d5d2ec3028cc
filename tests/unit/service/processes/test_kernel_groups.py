"""Every kernel belongs to exactly one group and is compiled before it is needed."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from itertools import groupby
from pathlib import Path

import pytest

from knifetip.kernels import Kernel
from knifetip.kernels.walk import kernels_of
from knifetip.service.processes import kernel_groups


def test_every_kernel_is_in_exactly_one_group() -> None:
    grouped = [each for names in kernel_groups.GROUPS.values() for each in kernels_of(*names)]
    found = list(kernels_of("knifetip"))
    assert len(found) > 200
    assert Counter(grouped) == Counter(found)


def test_parts_are_missing_in_the_order_of_the_groups(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Kernel, "is_cached", False)
    parts = kernel_groups.missing_parts()
    assert sum(part.kernels for part in parts) == len(list(kernels_of("knifetip")))
    assert len({part.module for part in parts}) == len(parts)
    groups = [group for group, _ in groupby(part.group for part in parts)]
    assert groups == ["drawings", "jobs", "offsets"]
    assert {part.group for part in kernel_groups.missing_parts("jobs")} == {"jobs"}


def test_a_module_is_compiled_with_progress_and_is_missing_no_more(tmp_path: Path) -> None:
    (tmp_path / "two_kernels.py").write_text(
        "from knifetip.kernels import kernel\n\n\n"
        "@kernel\ndef half(x: float) -> float:\n    return x / 2\n\n\n"
        "@kernel\ndef quarter(x: float) -> float:\n    return half(half(x))\n"
    )
    # Another process loads the kernels from the cache.
    program = (
        "from knifetip.service.processes import kernel_groups\n"
        "kernel_groups.GROUPS = {'one': ('two_kernels',)}\n"
        "print(kernel_groups.missing_parts(), list(kernel_groups.compile_module('two_kernels')), "
        "kernel_groups.missing_parts())"
    )
    command = [sys.executable, "-c", program]
    runs = [
        subprocess.run(
            command,
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "PYTHONPATH": str(tmp_path)},
        ).stdout.strip()
        for _ in range(2)
    ]
    missing = "[Part(group='one', module='two_kernels', kernels=2)]"
    assert runs == [f"{missing} [0.5, 1.0] []", "[] [] []"]


def test_a_group_that_does_not_exist_is_an_error() -> None:
    with pytest.raises(KeyError, match="gloves"):
        kernel_groups.missing_parts("gloves")


def test_a_group_that_is_complete_is_not_searched_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernel_groups, "_COMPILED", set())
    missing = [[kernel_groups.Part("drawings", "a module", 1)], []]
    monkeypatch.setattr(kernel_groups, "missing_parts", lambda _group: missing.pop(0))
    assert [kernel_groups.is_compiled("drawings") for _ in range(3)] == [False, True, True]
