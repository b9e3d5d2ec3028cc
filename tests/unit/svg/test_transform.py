"""Transforms, compared with values computed by hand and with NumPy matrices."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from knifetip.geometry.affine import IDENTITY, compose
from knifetip.svg.transform import parse_transform


def moved(text: str, x: float, y: float) -> tuple[float, float]:
    a, b, c, d, e, f = parse_transform(text)
    return a * x + c * y + e, b * x + d * y + f


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", (3, 2)),
        ("translate(10)", (13, 2)),
        ("translate(10, -5)", (13, -3)),
        ("scale(2)", (6, 4)),
        ("scale(2 -1)", (6, -2)),
        ("rotate(90)", (-2, 3)),
        ("rotate(-90, 3, 0)", (5, 0)),
        ("rotate(180)", (-3, -2)),
        ("matrix(1 2 3 4 5 6)", (3 + 6 + 5, 6 + 8 + 6)),
        ("translate(10,0) scale(2)", (16, 4)),
        ("scale(2),translate(10,0)", (26, 4)),
        (" translate( 1e1 , .5 )rotate(0) ", (13, 2.5)),
    ],
)
def test_transform_moves_the_point_three_two(text: str, place: tuple[float, float]) -> None:
    assert moved(text, 3.0, 2.0) == place


def test_skewing_by_45_degrees_moves_by_the_other_coordinate() -> None:
    assert_allclose(moved("skewX(45)", 3.0, 2.0), (5.0, 2.0))
    assert_allclose(moved("skewY(45)", 3.0, 2.0), (3.0, 5.0))


@pytest.mark.parametrize(
    "text",
    [
        "rotate",
        "rotate(",
        "rotate(1,2)",
        "matrix(1 2 3)",
        "spin(3)",
        "translate(a)",
        "scale(1) x",
        "rotate(1e999)",
        "translate(((((",
        "javascript:alert(1)",
    ],
)
def test_invalid_transforms_are_refused(text: str) -> None:
    with pytest.raises(ValueError):
        parse_transform(text)


numbers = st.floats(-100.0, 100.0).map(lambda value: round(value, 3))


@st.composite
def calls(draw: st.DrawFn) -> tuple[str, list[float]]:
    name = draw(st.sampled_from(["translate", "scale", "rotate", "skewX", "matrix"]))
    count = {"translate": 2, "scale": 2, "rotate": 3, "skewX": 1, "matrix": 6}[name]
    given_ = [draw(numbers) for _ in range(count)]
    if name == "skewX":
        given_ = [draw(st.floats(-80.0, 80.0))]
    return name, given_


def as_array(name: str, given_: list[float]) -> np.ndarray:
    out = np.eye(3)
    if name == "translate":
        out[:2, 2] = given_
    elif name == "scale":
        out[0, 0], out[1, 1] = given_
    elif name == "skewX":
        out[0, 1] = math.tan(math.radians(given_[0]))
    elif name == "matrix":
        out[:2] = np.array(given_).reshape(3, 2).T
    else:
        angle, x, y = given_
        turn = np.exp(1j * math.radians(angle))
        out[:2, :2] = [[turn.real, -turn.imag], [turn.imag, turn.real]]
        out[:2, 2] = [x, y] - out[:2, :2] @ [x, y]
    return out


@given(st.lists(calls(), max_size=5))
def test_a_list_is_the_product_of_its_matrices(listed: list[tuple[str, list[float]]]) -> None:
    text = " ".join(f"{name}({','.join(map(repr, given_))})" for name, given_ in listed)
    expected = np.eye(3)
    for name, given_ in listed:
        expected = expected @ as_array(name, given_)
    a, b, c, d, e, f = parse_transform(text)
    assert_allclose([[a, c, e], [b, d, f]], expected[:2], rtol=1e-9, atol=1e-6)


def test_blanks_do_not_change_a_matrix() -> None:
    one = parse_transform("rotate(30) translate(4 5)")
    assert compose(IDENTITY, one) == one == compose(one, IDENTITY)
