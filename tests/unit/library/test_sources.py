"""Every board and every tool of the library states where its figures come from."""

from __future__ import annotations

import re
import tomllib
from itertools import takewhile
from pathlib import Path
from typing import Final

import pytest

import knifetip.library

LIBRARY: Final = Path(knifetip.library.__file__).parent
BOARDS: Final = sorted((LIBRARY / "boards").glob("*.toml"))
TOOLS: Final = sorted((LIBRARY / "tools").glob("*.toml"))
#: What the comments name as a source: a publication, or the practice of the trade.
SOURCE: Final = re.compile(r'"[^"]+"|common practice')

#: The word in the comment of a tool for each of its figures.
WORDS: Final = {
    "back": "distances",
    "blade_angle": "blade angle",
    "blade_width": "width",
    "dwell": "dwell",
    "feed": "feed",
    "half_width": "distances",
    "lead": "lead-in",
    "plunge": "plunge",
    "radius": "radius|size",
    "speed": "speed",
    "spin_up": "spindle",
    "step": "step",
    "swivel": "swivel",
    "tilt": "tilt",
    "width": "rim",
}


def head(path: Path) -> str:
    """Return the comment at the beginning of a file, without its signs."""
    lines = takewhile(lambda line: line.startswith("#"), path.read_text().splitlines())
    return " ".join(line.removeprefix("#").strip() for line in lines)


@pytest.mark.parametrize("path", BOARDS, ids=lambda path: path.stem)
def test_the_figures_of_a_board_have_sources(path: Path) -> None:
    text = head(path)
    for word in ("Caliper:", "Crease:", "V-groove:", "Half-cut", "erforation"):
        assert word in text, word
    assert SOURCE.search(text)


@pytest.mark.parametrize("path", TOOLS, ids=lambda path: path.stem)
def test_the_figures_of_a_tool_have_sources(path: Path) -> None:
    figures = tomllib.loads(path.read_text())["tool"]
    text = head(path).lower()
    for field in figures.keys() - {"kind", "oscillating"}:
        assert re.search(rf"\b(?:{WORDS[field]})", text), field
    assert SOURCE.search(text)
