"""A new import format is checked by the layers contract without a change of the contract."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

BACKEND = Path(__file__).parents[3] / "backend"
CONFIG = """\
[importlinter]
root_package = shop
contract_types =
    pattern_layers: import_contracts.PatternLayersContract

[importlinter:contract:layers]
name = layers
type = pattern_layers
containers = shop
exhaustive = True
layers =
    api
    *.read | stage
    model
"""


@pytest.mark.parametrize(
    ("module", "content", "holds"),
    [
        ("newformat/read.py", "import shop.model", True),
        ("newformat/read.py", "import shop.api", False),
        ("newformat/tables.py", "import shop.api", False),
        ("newformat/tables.py", "import shop.stage", False),
        ("newformat/tables.py", "import shop.oldformat.read", False),
        ("model/__init__.py", "import shop.newformat.read", False),
        ("other/__init__.py", "", False),
    ],
)
def test_a_package_with_a_reader_belongs_to_the_layer_of_readers(
    tmp_path: Path, module: str, content: str, holds: bool
) -> None:
    for name in ("api", "stage", "model", "oldformat", "newformat"):
        (tmp_path / "shop" / name).mkdir(parents=True)
        (tmp_path / "shop" / name / "__init__.py").touch()
    (tmp_path / "shop" / "__init__.py").touch()
    for name in ("oldformat", "newformat"):
        (tmp_path / "shop" / name / "read.py").touch()
    file = tmp_path / "shop" / module
    file.parent.mkdir(exist_ok=True)
    (file.parent / "__init__.py").touch()
    file.write_text(content)
    (tmp_path / ".importlinter").write_text(CONFIG)
    done = subprocess.run(
        [Path(sys.executable).with_name("lint-imports"), "--no-cache"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": f"{tmp_path}:{BACKEND}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode == 0) == holds, done.stdout + done.stderr
