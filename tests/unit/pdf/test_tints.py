"""Programs that convert a tint to a colour."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip.pdf.tints import _run_program


@pytest.mark.parametrize(
    ("program", "left"),
    [
        (b"{0 exch 0 exch}", [0, 0, 0.5]),
        (b"{dup 2 mul exch pop}", [1]),
        (b"{1 sub neg 4 div}", [0.125]),
        (b"{1 2 3 1 index}", [0.5, 1, 2, 3, 2]),
        (b"{1 2 2 copy}", [0.5, 1, 2, 1, 2]),
        # Rolled upwards by one: the last becomes the first.
        (b"{1 2 3 3 1 roll}", [0.5, 3, 1, 2]),
        (b"{1 2 3 3 -1 roll}", [0.5, 2, 3, 1]),
        (b"{1 0 div}", []),
        (b"{pop pop}", []),
        (b"{0.5 gt {1} {0} ifelse}", []),
        (b"{1e300 dup mul 0 roll}", []),
        (b"{" + b"1 " * 200 + b"}", []),
    ],
)
def test_result_of_a_program_for_a_tint_of_one_half(program: bytes, left: list[float]) -> None:
    assert _run_program(program, 0.5) == left


WORDS = "add sub mul div neg pop dup exch index copy roll 0 1 2 -1 3 1e308 { }"


@given(st.lists(st.sampled_from(WORDS.split()), max_size=40))
def test_any_program_ends(program: list[str]) -> None:
    assert len(_run_program(" ".join(program).encode(), 1.0)) <= 100
