"""The planar graph and the classification do not depend on the order of edges in a file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from knifetip import pipeline
from knifetip.classification.classify import classify
from knifetip.classification.shape.features import extract_shape_features
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import I64
from knifetip.geometry.tolerance import GAP
from knifetip.library import load
from knifetip.model.drawing import Drawing
from knifetip.topology.faces import trace_faces
from knifetip.topology.morton_order import spatial_order
from knifetip.topology.planar_graph import build_graph
from tests.support.truth.known_types import KNOWN, Known, classification_fractions

TOUCH, REACH = GAP, 1.0


def in_order(drawing: Drawing, order: I64) -> Drawing:
    """Return the drawing with its edges in another order, given as rows."""
    columns = (
        *("ends", "bulge", "entity", "layer", "colour", "true_colour", "linetype"),
        "line_width",
    )
    return replace(drawing, **{name: getattr(drawing, name)[order] for name in columns})


def ring(count: int, step: float) -> np.ndarray:
    """Return a closed contour of short lines with length ``step``, (n, 2, 2)."""
    radius = count * step / (2.0 * np.pi)
    turn = 2.0 * np.pi * np.arange(count) / count
    points = radius * np.column_stack([np.cos(turn), np.sin(turn)])
    return np.stack([points, np.roll(points, -1, axis=0)], axis=1)


@given(st.floats(0.3, 1.6), st.integers(0, 1000))
def test_lines_as_short_as_what_touches_hang_together_in_any_order(steps: float, seed: int) -> None:
    ends = ring(200, steps * TOUCH)
    ends = np.ascontiguousarray(ends[np.random.default_rng(seed).permutation(len(ends))])
    graph = build_graph(ends, np.zeros(len(ends)), TOUCH, REACH)
    assert graph is not None
    assert len(graph.leftmost) == 1
    # One face inside, one outside.
    area = trace_faces(graph, ends, np.zeros(len(ends)), TOUCH).area
    radius = 200 * steps * TOUCH / (2.0 * np.pi)
    assert area.max() == pytest.approx(np.pi * radius**2, rel=0.1)


def test_ends_at_one_point_are_at_one_place_though_another_is_nearer() -> None:
    # The second and the fourth edge start at one point; the third creates a nearer vertex.
    away = 0.7 * TOUCH
    ends = np.array(
        [
            [[-9.0, 0.0], [0.0, 0.0]],
            [[away, 0.0], [9.0, 9.0]],
            [[1.6 * away, 0.0], [9.0, -9.0]],
            [[away, 0.0], [9.0, 0.0]],
        ]
    )
    graph = build_graph(ends, np.zeros(4), TOUCH, REACH)
    assert graph is not None
    assert graph.end_vertex[1] == graph.end_vertex[2] == graph.end_vertex[6] != graph.end_vertex[4]


@pytest.mark.corpus
@pytest.mark.parametrize("known", KNOWN, ids=lambda known: Path(known.path).name)
def test_what_is_known_is_said_of_a_shuffled_file_too(corpus: Path, known: Known) -> None:
    drawing = pipeline.read((corpus / known.path).read_bytes())
    truth = known.truth(drawing)
    line_type = classify(drawing, load.profile("default"), load.conventions()).line_type
    right, _, _ = classification_fractions(truth, line_type, drawing.lengths)
    order = np.random.default_rng(7).permutation(len(drawing))
    other = in_order(drawing, order)
    line_type = classify(other, load.profile("default"), load.conventions()).line_type
    right_too, _, wrong = classification_fractions(truth[order], line_type, other.lengths)
    assert wrong == 0.0
    assert right_too >= right - 1e-3


def sheet(copies: int) -> np.ndarray:
    """Return small cartons of two panels, line by line, (5 · copies, 2, 2)."""
    corners = np.array([(0, 0), (10, 0), (10, 10), (0, 10)], float)
    rim = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
    carton = np.concatenate([rim, [[(5, 0), (5, 10)]]])
    shift = 12.0 * np.stack(np.divmod(np.arange(copies), 100), axis=1)
    return (carton[None] + shift[:, None, None]).reshape(-1, 2, 2)


def test_a_scattered_sheet_is_looked_at_in_an_order_of_its_own_and_said_to_be_the_same() -> None:
    whole = sheet(5000)
    assert spatial_order(whole) is None
    mixed = np.random.default_rng(0).permutation(len(whole))
    order = spatial_order(whole[mixed])
    assert order is not None
    assert (np.sort(order) == np.arange(len(whole))).all()
    # In this order consecutive edges are near each other.
    leap = np.abs(np.diff(whole[mixed][order, 0], axis=0)).max(axis=1)
    assert np.median(leap) <= 24.0
    straight = np.zeros(len(whole))
    one, other = (
        extract_shape_features(whole, straight),
        extract_shape_features(whole[mixed], straight),
    )
    assert one.role.reshape(-1, 5).tolist() == [[Role.OUTLINE] * 4 + [Role.DIVIDER]] * 5000
    assert (one.role[mixed] == other.role).all()
    assert np.bincount(other.component).tolist() == [5] * 5000
    assert np.sort(other.face_area).tolist() == pytest.approx(np.sort(one.face_area).tolist())
    # The faces of each edge belong to its own carton.
    assert (np.abs(other.face_area[other.faces]) == np.abs(one.face_area[one.faces[mixed]])).all()


def test_few_edges_and_edges_at_one_point_keep_their_order() -> None:
    assert spatial_order(np.zeros((10, 2, 2))) is None
    assert spatial_order(np.ones((30_000, 2, 2))) is None
