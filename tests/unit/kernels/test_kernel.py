"""Kernels have one signature, declared by their annotations; errors name the argument."""

from __future__ import annotations

import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numba
import numpy as np
import pytest
from numba.core.caching import NullCache
from numba.core.errors import TypingError

from knifetip.kernels import F64_1, I32_1, U64, Kernel, OutI64_1, inline_kernel, kernel
from knifetip.kernels.walk import kernels_of


class Tables(NamedTuple):
    """Arrays passed to a kernel: values, the number of used values, and an array for the result."""

    values: F64_1
    used: int
    result: OutI64_1


@inline_kernel
def _at(values: F64_1, i: int) -> float:
    return float(values[i])


@kernel
def _sum(values: F64_1, first: int, more: float, twice: bool) -> float:
    total = _at(values, 0) + _at(values, first) + _at(values, -1) + more
    return 2.0 * total if twice else total


@kernel
def _count(tables: Tables) -> int:
    tables.result[0] = tables.used
    return int(tables.result[0])


@kernel
def _sum_of_sums(tables: Tables, other: F64_1) -> float:
    again = Tables(other, 2, tables.result)
    return (
        _sum(tables.values, 0, 0, False)
        + _sum(other, -1, 1.0, True)
        + _sum(tables.values[1:], 0, 0.0, True)
        + _count(tables)
        + _count(again)
    )


@kernel
def _half(x: float, y: float) -> float:
    return x / y


@kernel(checks_division=True)
def _checked_half(x: float, y: float) -> float:
    return x / y


@kernel(allocates=False)
def _wide(x: U64, rows: I32_1) -> int:
    return int(x) + int(rows[0])


@pytest.fixture(autouse=True, scope="module")
def _compiled_here() -> None:
    """Disable the cache of all test kernels, so that they are compiled in this process."""
    for each in (_at, _sum, _count, _sum_of_sums, _half, _checked_half, _wide):
        assert isinstance(each, Kernel)
        vars(each)["_cache"] = NullCache()


def _signatures(function: Callable[..., Any]) -> int:
    assert isinstance(function, Kernel)
    return len(function.signatures)


def _frozen(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    values.flags.writeable = False
    return values


VALUES = np.arange(1.0, 5.0)


def test_a_kernel_is_compiled_at_its_first_call_and_not_before() -> None:
    @kernel
    def twice(x: float) -> float:
        return 2.0 * x

    assert _signatures(twice) == 0
    assert twice(1.5) == 3.0
    assert _signatures(twice) == 1


def test_read_only_arrays_narrow_numbers_and_integers_for_floats_use_one_signature() -> None:
    assert _sum(VALUES, 1, 0.0, False) == 1.0 + 2.0 + 4.0
    untyped: Callable[..., float] = _sum
    assert untyped(_frozen(VALUES.copy()), np.int32(1), 3, True) == 20.0
    assert untyped(VALUES, np.int64(1), np.float64(3.0), np.bool_(True)) == 20.0
    assert _signatures(_sum) == 1


def test_constants_and_slices_inside_kernels_use_one_signature() -> None:
    tables = Tables(VALUES, 4, np.zeros(1, np.int64))
    frozen = Tables(_frozen(VALUES.copy()), 4, np.zeros(1, np.int64))
    assert _sum_of_sums(tables, VALUES) == 6.0 + 20.0 + 16.0 + 4 + 2
    assert _sum_of_sums(frozen, _frozen(VALUES.copy())) == _sum_of_sums(tables, VALUES)
    assert tables.result[0] == 2
    assert {_signatures(f) for f in (_sum_of_sums, _sum, _count, _at)} == {1}


@pytest.mark.parametrize(
    ("call", "named"),
    [
        (lambda: _sum(VALUES, 1.5, 0.0, False), "argument first is float64, declared is int64"),  # type: ignore[arg-type]  # wrong on purpose
        (lambda: _sum(VALUES.astype(np.float32), 1, 0.0, False), "argument values is array"),
        (lambda: _sum(VALUES[::2], 1, 0.0, False), "argument values is array"),
        (lambda: _wide(np.uint64(1), np.zeros(1, np.int64)), "argument rows is array"),
        (lambda: _count(Tables(VALUES, 1, np.zeros(1, np.int32))), "argument tables is Tables"),
        (lambda: _count(Tables(VALUES, 1, _frozen(np.zeros(1, np.int64)))), "argument tables"),
    ],
)
def test_what_is_not_as_declared_is_refused_by_the_name_of_its_argument(
    call: Callable[[], object], named: str
) -> None:
    with pytest.raises(TypeError, match=named):
        call()


def test_no_kernel_casts_a_float_to_an_integer_in_a_call() -> None:
    @kernel
    def wrong(values: F64_1) -> float:
        return _at(values, values[0])

    with pytest.raises(TypingError, match="argument i is float64, declared is int64"):
        wrong(VALUES)


def test_a_kernel_cannot_write_to_what_it_declares_as_read_only() -> None:
    @kernel
    def wrong(values: F64_1) -> float:
        values[0] = 1.0
        return 0.0

    with pytest.raises(TypingError, match="readonly"):
        wrong(VALUES)


@pytest.mark.parametrize("missing", ["annotation", "default", "vocabulary"])
def test_a_declaration_that_is_not_complete_is_refused(missing: str) -> None:
    def no_annotation(x):  # type: ignore[no-untyped-def]  # this is what the test is about
        return float(x)

    def default(x: float = 1.0) -> float:
        return x

    def vocabulary(x: list[float]) -> float:
        return x[0]

    functions: dict[str, Callable[..., float]] = {
        "annotation": no_annotation,
        "default": default,
        "vocabulary": vocabulary,
    }
    with pytest.raises(TypeError, match=f"argument x.*{missing}"):
        kernel(functions[missing])(1.0)


def test_division_by_zero_is_an_error_only_where_that_is_wanted() -> None:
    assert _half(1.0, 0.0) == np.inf
    with pytest.raises(ZeroDivisionError):
        _checked_half(1.0, 0.0)


def test_a_kernel_that_allocates_may_be_called_by_one_that_does_not() -> None:
    @kernel
    def room(count: int) -> int:
        return len(np.empty(count))

    @kernel(allocates=False)
    def calling(count: int) -> int:
        return room(count) + 1

    assert calling(3) == 4


def test_every_kernel_of_the_package_declares_one_signature() -> None:
    found = list(kernels_of("knifetip"))
    for each in found:
        assert isinstance(each, Kernel)
        assert len(each.declared) == each.py_func.__code__.co_argcount
        assert len(each.signatures) <= 1
    assert len({each.py_func for each in found}) == len(found)


def test_a_loaded_kernel_is_linked_into_one_that_is_compiled_later(tmp_path: Path) -> None:
    (tmp_path / "two.py").write_text(
        "from typing import NamedTuple\n"
        "from knifetip.kernels import F64_1, kernel\n"
        "class Pair(NamedTuple):\n    a: int\n    b: int\n"
        "@kernel\ndef product(pair: Pair) -> int:\n    return pair.a * pair.b\n"
        "@kernel\ndef total(values: F64_1) -> float:\n    return values.copy().sum()\n"
        "@kernel\ndef twice(values: F64_1) -> float:\n    return 2.0 * total(values)\n"
    )
    program = (
        "import sys, numpy as np, two\n"
        "for name in sys.argv[1:]:\n    assert getattr(two, name)(np.ones(3)) > 2.0\n"
        "print(*(len(getattr(two, name)._cache_hits) for name in sys.argv[1:]))"
    )

    def hits(*names: str) -> str:
        done = subprocess.run(
            [sys.executable, "-c", program, *names], cwd=tmp_path, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    def rewrite(old: str, new: str) -> None:
        (tmp_path / "two.py").write_text((tmp_path / "two.py").read_text().replace(old, new))

    assert hits("total") == "0"
    assert hits("total", "twice") == "1 0"
    assert hits("twice", "total") == "1 1"
    product = "import two; print(two.product(two.{}(2, 3)), len(two.product._cache_hits))"

    def multiply(name: str) -> str:
        code = product.format(name)
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    assert multiply("Pair") == "6 0"
    assert multiply("Pair") == "6 1"
    rewrite("Pair", "Duo")
    assert multiply("Duo") == "6 0"


BROKEN_FILES = {
    "truncated": b"\x80",
    "not a pickle": b"no pickle",
    "deleted class": pickle.dumps(numba.__version__) + b"cknifetip.kernels\nDeletedRecord\n.",
}


@pytest.mark.parametrize(
    "index",
    [
        # The others are refused by the same statement.
        pytest.param(index, id=name, marks=() if name == "deleted class" else pytest.mark.long)
        for name, index in BROKEN_FILES.items()
    ],
)
def test_a_cache_file_that_cannot_be_loaded_is_overwritten(tmp_path: Path, index: bytes) -> None:
    (tmp_path / "one.py").write_text(
        "from knifetip.kernels import kernel\n"
        "@kernel\ndef half(x: float) -> float:\n    return x / 2\n"
    )
    program = "import one; print(one.half.is_cached, one.half(3.0), one.half.is_cached)"

    def output() -> str:
        done = subprocess.run(
            [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    assert output() == "False 1.5 True"
    (file,) = (tmp_path / "__pycache__").glob("one.half*.nbi")
    file.write_bytes(index)
    assert output() == "False 1.5 True"
    assert output() == "True 1.5 True"
    (code,) = (tmp_path / "__pycache__").glob("one.half*.nbc")
    code.write_bytes(b"cknifetip.kernels\nDeletedRecord\n.")
    assert output() == "True 1.5 True"
    assert code.stat().st_size > 1000
