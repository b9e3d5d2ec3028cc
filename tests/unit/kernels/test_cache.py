"""Machine code is read from a folder that cannot be written to, as in a read-only image."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest
from numba.core import caching

from knifetip.kernels.cache import KernelCache


def refuse(*_arguments: object, **_options: object) -> None:
    raise OSError(errno.EROFS, "Read-only file system")


@pytest.fixture
def _read_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make numba find no writable folder."""
    (Path(__file__).parent / "__pycache__").mkdir(exist_ok=True)
    monkeypatch.setattr("tempfile.TemporaryFile", refuse)
    monkeypatch.setattr("os.makedirs", refuse)


def adds(value: int) -> int:
    """Return a number, as a function that could be a kernel."""
    return value + 1


@pytest.mark.usefixtures("_read_only")
def test_kernels_are_searched_in_a_folder_that_cannot_be_written_to() -> None:
    with pytest.raises(RuntimeError, match="no locator"):
        caching.FunctionCache(adds)  # type: ignore[no-untyped-call]  # numba has no types
    cache = KernelCache(adds)
    assert Path(cache.cache_path) == Path(__file__).parent / "__pycache__"


def test_a_kernel_that_cannot_be_stored_is_used_nevertheless(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    cache = KernelCache(adds)
    monkeypatch.setattr(caching.FunctionCache, "save_overload", refuse)
    cache.save_overload(None, None)  # type: ignore[arg-type]  # not used

    def full(*_arguments: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(caching.FunctionCache, "save_overload", full)
    with pytest.raises(OSError, match="No space"):
        cache.save_overload(None, None)  # type: ignore[arg-type]  # not used
