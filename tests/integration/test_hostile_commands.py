"""Malicious files on the command line are refused with exit code 3, a reason and a hint."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.support.command import Command
from tests.support.grid import in_turn
from tests.support.writers import hostile

_MAKE = ("--machine", "demo-table", "--board", "e-flute", "-o", "made.ngc")
_SMALL = [name for name in hostile.REFUSED if "60 MB" not in name]


def check_refused(result: tuple[int, str, str], word: str) -> None:
    code, out, err = result
    assert code == 3
    assert out == ""
    assert "Traceback" not in err
    message, hint = err.strip().split("\n")
    assert word in message
    assert hint


# In `make test` the large ones are sent to a server only (test_hostile_uploads.py).
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name in _SMALL else pytest.mark.long)
        for name in hostile.REFUSED
    ],
)
def test_a_hostile_file_is_not_read(knifetip: Command, tmp_path: Path, name: str) -> None:
    _, word, made = hostile.REFUSED[name]
    file = tmp_path / "drawing"
    file.write_bytes(made())
    check_refused(knifetip("read", file), word)


@pytest.mark.parametrize(
    ("name", "words"), in_turn(_SMALL, [("classify",), ("clean",), ("program", *_MAKE)])
)
def test_no_output_is_written_for_a_hostile_file(
    knifetip: Command,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    name: str,
    words: tuple[str, ...],
) -> None:
    _, word, made = hostile.REFUSED[name]
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "drawing"
    file.write_bytes(made())
    command, *more = words
    check_refused(knifetip(command, file, *more), word)
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize("name", hostile.READ)
def test_hostile_parts_of_a_file_are_omitted_and_reported(
    knifetip: Command, tmp_path: Path, name: str
) -> None:
    word, _, made = hostile.READ[name]
    file = tmp_path / "drawing"
    file.write_bytes(made())
    code, out, err = knifetip("read", file, "--unit", "mm")
    assert (code, err) == (0, "")
    assert word in out


def test_a_file_of_a_terabyte_is_refused_after_64_megabytes(
    knifetip: Command, tmp_path: Path
) -> None:
    file = tmp_path / "drawing"
    file.touch()
    os.truncate(file, 1 << 40)
    check_refused(knifetip("read", file), "larger than 64 MB")
