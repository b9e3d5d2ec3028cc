"""knifetip clean: the ledger of cleaning, printed."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from knifetip.cli import main
from tests.support.writers import dxf_text as text


@pytest.fixture
def cleaned(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]):
    """Run the command on a few lines; returns exit code and stdout."""

    def run(*lines, options=(), units=4):
        file = tmp_path / "sheet.dxf"
        file.write_bytes(text.dxf(*lines, units=units))
        monkeypatch.setattr(sys, "argv", ["knifetip", "clean", str(file), *options])
        with pytest.raises(SystemExit) as left:
            main()
        return left.value.code, capfd.readouterr().out

    return run


def cut(*ends: float) -> str:
    return text.line(*ends, (8, "CUT"))


def test_the_lengths_add_up_and_every_changed_edge_is_told(cleaned) -> None:
    code, out = cleaned(cut(0, 0, 100, 0), cut(40, 0, 70, 0), cut(100.03, 0, 200, 0))
    assert code == 0
    assert "drawn 229.970 mm = kept 199.970 + merged 30.000 + dropped 0.000" in out
    assert "worked 200.000 mm = kept 199.970 + added by closing gaps 0.030" in out
    assert "edge 1: merged: it lies on edge 0" in out
    assert "edge 2: merged: it goes on in edge 0 and is one with it" in out


def test_json_has_the_same(cleaned) -> None:
    code, out = cleaned(cut(0, 0, 100, 0), cut(40, 0, 70, 0), options=("--json",))
    assert code == 0
    data = json.loads(out)["cleaning"]
    assert data["lengths"]["merged"] == 30
    assert [row["why"] for row in data["rows"]] == ["twice"]


def test_without_a_unit_it_asks(cleaned) -> None:
    code, _ = cleaned(cut(0, 0, 3, 0), units=None)
    assert code == 2
