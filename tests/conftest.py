"""What all tests share: the drawings by other hands, and where they are."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import settings

# A busy machine is no finding: what takes long is shown by `make bench`.
settings.register_profile("knifetip", deadline=None)
settings.load_profile("knifetip")

ROOT = Path(__file__).resolve().parents[1]
CORPUS = Path(os.environ.get("KNIFETIP_CORPUS", ROOT.parent / "shared" / "corpus"))


@pytest.fixture(scope="session")
def corpus() -> Path:
    """The folder of drawings by other hands; skips where it is absent."""
    if not CORPUS.is_dir():
        pytest.skip(f"the drawings by other hands are not at {CORPUS} (set KNIFETIP_CORPUS)")
    return CORPUS
