"""knifetip clean: printed lengths and changed edges."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from knifetip.cli import main
from tests.support.writers import dxf_text as text

RunClean = Callable[..., tuple[int, str]]


@pytest.fixture
def run_clean(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> RunClean:
    """Return a function that runs ``knifetip clean`` on a DXF file; it returns exit code and
    stdout.
    """

    def run(*lines: str, options: Sequence[str] = (), units: int | None = 4) -> tuple[int, str]:
        file = tmp_path / "sheet.dxf"
        file.write_bytes(text.dxf(*lines, units=units))
        monkeypatch.setattr(sys, "argv", ["knifetip", "clean", str(file), *options])
        with pytest.raises(SystemExit) as exit_info:
            main()
        assert isinstance(exit_info.value.code, int)
        return exit_info.value.code, capfd.readouterr().out

    return run


def cut(x1: float, y1: float, x2: float, y2: float) -> str:
    return text.line(x1, y1, x2, y2, (8, "CUT"))


def test_the_lengths_add_up_and_every_changed_edge_is_listed(run_clean: RunClean) -> None:
    code, out = run_clean(cut(0, 0, 100, 0), cut(40, 0, 70, 0), cut(100.03, 0, 200, 0))
    assert code == 0
    assert "drawn 229.970 mm = kept 199.970 + merged 30.000 + dropped 0.000" in out
    assert "processed 200.000 mm = kept 199.970 + added by closing gaps 0.030" in out
    assert "edge 1: the edge lies on edge 0 and was merged into it" in out
    assert "edge 2: the edge was merged into edge 0, which lies on the same line" in out


def test_json_output_lists_the_changed_edges(run_clean: RunClean) -> None:
    code, out = run_clean(cut(0, 0, 100, 0), cut(40, 0, 70, 0), options=("--json",))
    assert code == 0
    data = json.loads(out)["cleaning"]
    assert data["lengths"]["merged"] == 30
    assert [row["reason"] for row in data["rows"]] == ["twice"]


def test_a_drawing_without_a_unit_exits_with_2(run_clean: RunClean) -> None:
    code, _ = run_clean(cut(0, 0, 3, 0), units=None)
    assert code == 2
