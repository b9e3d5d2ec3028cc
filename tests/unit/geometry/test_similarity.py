"""The similarity of least squares, against NumPy's solver and transforms of shapely."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import MultiPoint, affinity, get_coordinates

from knifetip.geometry.columns import F64
from knifetip.geometry.similarity import Similarity, fit_similarity, is_mirrored

MARKS = np.array([(10.0, 10.0), (700.0, 25.0), (690.0, 480.0), (15.0, 470.0), (300.0, 200.0)])


def moved(points: F64, turn: float, scale: float, shift: tuple[float, float]) -> F64:
    """Points that shapely has turned and scaled about the origin, and then shifted."""
    shape = affinity.rotate(MultiPoint(points), turn, origin=(0, 0))
    shape = affinity.scale(shape, scale, scale, origin=(0, 0))
    return np.array(get_coordinates(affinity.translate(shape, *shift)))


@pytest.mark.parametrize("turn", [0.0, 0.7, -3.0, 90.0, 179.0])
@pytest.mark.parametrize("count", [2, 5])
def test_an_exact_similarity_is_found(turn: float, count: int) -> None:
    target = moved(MARKS[:count], turn, 1.004, (30.0, -12.5))
    found = fit_similarity(MARKS[:count], target)
    assert found.turn == pytest.approx(turn, abs=1e-9)
    assert found.scale == pytest.approx(1.004, abs=1e-12)
    assert (found.x, found.y) == pytest.approx((30.0, -12.5), abs=1e-9)
    np.testing.assert_allclose(found.apply(MARKS[:count]), target, atol=1e-9)
    np.testing.assert_allclose(found.inverse.apply(target), MARKS[:count], atol=1e-9)


def least_squares(source: F64, target: F64) -> F64:
    """a, b, x, y of least squares, from the overdetermined linear system."""
    x, y = source.T
    one, zero = np.ones(len(x)), np.zeros(len(x))
    rows = np.concatenate(
        [np.stack([x, -y, one, zero], axis=1), np.stack([y, x, zero, one], axis=1)]
    )
    solution: F64 = np.linalg.lstsq(rows, target.T.ravel(), rcond=None)[0]
    return solution


@pytest.mark.parametrize("seed", range(5))
def test_noisy_marks_have_the_least_squares_of_numpy(seed: int) -> None:
    noise = np.random.default_rng(seed).normal(0.0, 0.3, MARKS.shape)
    target = moved(MARKS, 2.5, 0.997, (50.0, 20.0)) + noise
    np.testing.assert_allclose(fit_similarity(MARKS, target), least_squares(MARKS, target))


@pytest.mark.parametrize("seed", range(3))
def test_no_other_turn_fits_better_if_the_scale_is_kept(seed: int) -> None:
    noise = np.random.default_rng(seed).normal(0.0, 0.3, MARKS.shape)
    target = moved(MARKS, -1.0, 1.003, (50.0, 20.0)) + noise
    found = fit_similarity(MARKS, target, keep_scale=True)
    assert found.scale == pytest.approx(1.0, abs=1e-12)

    def squares(similarity: Similarity) -> float:
        return float(((similarity.apply(MARKS) - target) ** 2).sum())

    def turned(angle: float) -> Similarity:
        a, b = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        rest = target.mean(axis=0) - Similarity(a, b, 0.0, 0.0).apply(MARKS.mean(axis=0))
        return Similarity(a, b, *rest.tolist())

    assert squares(turned(found.turn)) == pytest.approx(squares(found))
    assert min(squares(turned(found.turn + step)) for step in (-0.01, 0.01)) > squares(found)


def test_mirrored_marks_are_found() -> None:
    target = moved(MARKS * (-1.0, 1.0), 30.0, 1.0, (800.0, 0.0))
    assert is_mirrored(MARKS, target)
    assert not is_mirrored(MARKS, moved(MARKS, 30.0, 1.0, (800.0, 0.0)))
    assert not is_mirrored(MARKS[:2], target[:2])  # two points fit both ways
