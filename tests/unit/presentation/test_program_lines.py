from __future__ import annotations

import pytest

from knifetip.presentation.program_lines import select_lines

TEXT = b"%\nG0 X1\n\nM2\n"


@pytest.mark.parametrize("first", range(1, 7))
@pytest.mark.parametrize("count", [1, 2, 10])
def test_lines_are_those_of_python(first: int, count: int) -> None:
    lines = TEXT.splitlines(keepends=True)
    assert select_lines(TEXT, first, count) == b"".join(lines[first - 1 : first - 1 + count])


def test_a_program_without_lines_has_none() -> None:
    assert select_lines(b"", 1, 5) == b""
