"""Import the scripts beside the package, such as the one that writes the page of licences."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

BACKEND = Path(__file__).resolve().parents[2] / "backend"


def load_script(name: str) -> ModuleType:
    """Return the module of ``backend/NAME.py``."""
    spec = importlib.util.spec_from_file_location(name, BACKEND / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
