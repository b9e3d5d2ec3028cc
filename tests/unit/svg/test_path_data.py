"""Path data, parsed by the kernel and, for comparison, by a short Python function."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from knifetip.drawing_builder.path_table import ARC, CUBIC, LINE
from knifetip.svg.path_data import ScannedPaths, scan_paths


def table(*paths: str) -> ScannedPaths:
    found = scan_paths(paths, 10**6)
    assert found is not None
    return found


def corners(path: str) -> list[list[float]]:
    """Return x and y of both ends of each segment."""
    found: list[list[float]] = table(path).numbers[:, :4].tolist()
    return found


def test_a_closed_triangle_is_three_lines() -> None:
    assert corners("M 0 0 L 10 0 L 10 5 Z") == [[0, 0, 10, 0], [10, 0, 10, 5], [10, 5, 0, 0]]


def test_relative_commands_start_at_the_current_point() -> None:
    assert corners("m1 2 l3 4 h5 v-6 z") == [
        [1, 2, 4, 6],
        [4, 6, 9, 6],
        [9, 6, 9, 0],
        [9, 0, 1, 2],
    ]


def test_further_coordinates_of_a_move_are_lines() -> None:
    assert corners("M0,0 10,0 10,5") == [[0, 0, 10, 0], [10, 0, 10, 5]]
    assert corners("m1,1 2,0 0,3") == [[1, 1, 3, 1], [3, 1, 3, 4]]


def test_closing_returns_to_the_start_of_the_contour() -> None:
    assert corners("M1 1 h2 v2 z l-1 -1")[-1] == [1, 1, 0, 0]


def test_closing_a_closed_contour_adds_no_line() -> None:
    assert len(corners("M0 0H10V10H0V0Z")) == 4


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("M1.5.5-2-3", [1.5, 0.5, -2, -3]),
        ("M1e1 2E-1 3e+0 .4", [10, 0.2, 3, 0.4]),
        ("M+1,+2,,3 4.", [1, 2, 3, 4]),
        ("M\t0\r\n0\n,5 6", [0, 0, 5, 6]),
        ("M0 0 123456789012345678901234 0.000000000000000000001234", [0, 0, 1.2345678901234568e23,
                                                                    1.234e-21]),
        ("M0 0 1e-400 1e400", [0, 0, 0, math.inf]),
    ],
)  # fmt: skip
def test_numbers_need_no_separator(text: str, numbers: list[float]) -> None:
    assert_allclose(table(text).numbers[0, :4], numbers, rtol=1e-15)


def test_flags_of_an_arc_need_no_separator() -> None:
    one = table("M0 0a5 5 30 0110 0")
    two = table("M0 0 A 5,5 30 0 1 10,0")
    assert_array_equal(one.numbers, two.numbers)
    assert one.kind.tolist() == [ARC]
    assert one.numbers[0].tolist() == [0, 0, 10, 0, 5, 5, 30, 2]


def test_an_arc_without_a_radius_is_a_line() -> None:
    assert table("M0 0A0 5 0 0 1 3 4").kind.tolist() == [LINE]


def test_a_smooth_cubic_mirrors_the_handle_before_it() -> None:
    found = table("M0 0C1 2 3 4 5 5S9 9 10 0")
    assert found.kind.tolist() == [CUBIC, CUBIC]
    assert found.numbers[1].tolist() == [5, 5, 10, 0, 7, 6, 9, 9]


def test_a_smooth_cubic_after_a_line_has_its_handle_at_the_start() -> None:
    assert table("M0 0H5S9 9 10 0").numbers[1].tolist() == [5, 0, 10, 0, 5, 0, 9, 9]


def test_quadratic_curves_become_cubic_ones() -> None:
    # Q with the handle (3, 6): the handles of the cubic are two thirds of the way to it.
    found = table("M0 0Q3 6 6 0t6 0")
    assert_allclose(found.numbers[0], [0, 0, 6, 0, 2, 4, 4, 4])
    assert_allclose(found.numbers[1], [6, 0, 12, 0, 8, -4, 10, -4])


@pytest.mark.parametrize(
    ("text", "drawn", "at"),
    [
        ("L 1 1", 0, 0),
        ("5 5", 0, 0),
        ("M0 0L1", 0, 5),
        ("M0 0L1 1X", 1, 8),
        ("M0 0 10 0 nan 3", 1, 10),
        ("M0 0a5 5 0 2 1 10 0", 0, 5),
        ("M0 0z5 5", 0, 5),
        ("M0 0 5 5 1em", 1, 9),
        ("M0 0 5 5 <!ENTITY", 1, 9),
    ],
)
def test_a_path_is_read_up_to_its_first_error(text: str, drawn: int, at: int) -> None:
    found = table(text)
    assert len(found.kind) == drawn
    assert found.wrong.tolist() == [at]


def test_paths_are_independent() -> None:
    found = table("M0 0H1", "", "M5 5", "H7", "M2 2V3")
    assert found.path.tolist() == [0, 4]
    assert found.wrong.tolist() == [-1, -1, -1, 0, -1]


def test_too_many_segments_return_none() -> None:
    assert scan_paths(["M0 0" + "h1" * 1000], 999) is None
    assert scan_paths(["M0 0" + "h1" * 999], 999) is not None


numbers = st.one_of(
    st.floats(-1e6, 1e6, allow_nan=False),
    st.integers(-1000, 1000).map(float),
    st.floats(-1e-3, 1e-3),
)
TAKES = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "Z": 0}


@st.composite
def drawings(draw: st.DrawFn) -> list[tuple[str, list[float]]]:
    first = ("M", [draw(numbers), draw(numbers)])
    letters = st.sampled_from(sorted([*TAKES, *(letter.lower() for letter in TAKES)]))
    rest = draw(st.lists(letters, max_size=12))
    return [first, *((name, [draw(numbers) for _ in range(TAKES[name.upper()])]) for name in rest)]


def reference_segments(commands: list[tuple[str, list[float]]]) -> list[tuple[complex, ...]]:
    """Return the control points of each segment as complex numbers, following the standard."""
    out: list[tuple[complex, ...]] = []
    pen = home = 0j
    cubic = quadratic = None
    for name, values in commands:
        base = pen if name.islower() else 0j
        points = [base + complex(x, y) for x, y in zip(values[::2], values[1::2], strict=False)]
        upper = name.upper()
        start, handles = pen, (cubic, quadratic)
        cubic = quadratic = None
        if upper == "M":
            pen = home = points[0]
            continue
        if upper == "L":
            pen = points[0]
            out.append((start, pen))
        elif upper == "H":
            pen = complex(base.real + values[0], pen.imag)
            out.append((start, pen))
        elif upper == "V":
            pen = complex(pen.real, base.imag + values[0])
            out.append((start, pen))
        elif upper == "Z":
            pen = home
            if start != home:
                out.append((start, home))
        elif upper in "CS":
            if upper == "S":
                points.insert(0, 2 * start - handles[0] if handles[0] is not None else start)
            cubic, pen = points[1], points[2]
            out.append((start, *points))
        else:
            if upper == "T":
                points.insert(0, 2 * start - handles[1] if handles[1] is not None else start)
            quadratic, pen = points
            out.append((start, *points))
    return out


def at(control: tuple[complex, ...], t: float) -> complex:
    """Return a point of a Bézier curve, computed with de Casteljau's algorithm."""
    points = list(control)
    while len(points) > 1:
        points = [(1 - t) * a + t * b for a, b in pairwise(points)]
    return points[0]


@given(drawings(), st.sampled_from([" ", ",", " , ", "\n"]))
def test_any_path_equals_the_reference(
    commands: list[tuple[str, list[float]]], between: str
) -> None:
    text = "".join(
        name + between.join(repr(number) for number in values) for name, values in commands
    )
    found = table(text)
    expected = reference_segments(commands)
    assert found.wrong.tolist() == [-1]
    assert len(found.kind) == len(expected)
    for kind, row, control in zip(found.kind, found.numbers, expected, strict=True):
        pairs = row.reshape(4, 2) @ [1, 1j]
        points = (pairs[0], pairs[1]) if kind == LINE else (pairs[0], *pairs[2:], pairs[1])
        scale = max(abs(point) for point in control) + 1e-3
        for t in (0.0, 0.3, 1.0):
            assert abs(at(tuple(points), t) - at(control, t)) <= 1e-12 * scale


@given(st.text(alphabet="MmLlHhVvCcSsQqTtAaZz0123456789.-+eE ,\nx", max_size=60))
def test_any_text_gives_segments_or_an_error_index(text: str) -> None:
    found = table(text)
    assert len(found.kind) == len(found.numbers) == len(found.path)
    assert -1 <= found.wrong[0] <= len(text)


@given(st.floats(-1e12, 1e12))
def test_any_number_equals_that_of_python(number: float) -> None:
    read = table(f"M0 0L{number!r} 0").numbers[0, 2]
    assert math.isclose(read, number, rel_tol=4e-16, abs_tol=1e-25)
