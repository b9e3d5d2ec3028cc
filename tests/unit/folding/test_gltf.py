"""GLB files, read by trimesh, which shares no code with the writer."""

from __future__ import annotations

import io
import json
import struct
from typing import Any

import numpy as np
import pytest
import trimesh

from knifetip.folding.gltf import write_glb
from knifetip.folding.motion import panel_transforms
from knifetip.folding.solid import panel_solids
from tests.support.shapes import BOARD, closed, edges
from tests.unit.folding.blanks import CREASE, CUT, GROOVE, THIN, cross, folded

A = 40.0


def load(content: bytes) -> Any:
    return trimesh.load(io.BytesIO(content), file_type="glb")


def fields(content: bytes) -> dict[str, Any]:
    (length,) = struct.unpack_from("<I", content, 12)
    read: dict[str, Any] = json.loads(content[20 : 20 + length])
    return read


def test_a_cube_has_the_size_of_its_sides_in_metres_with_y_upwards() -> None:
    tree = folded(*cross(A), board=THIN)
    scene = load(write_glb(tree, 1.0, outside_up=False))
    np.testing.assert_allclose(
        scene.bounds, [[0.0, 0.0, -2e-3 * A], [1e-3 * A, 1e-3 * A, -1e-3 * A]], atol=1e-6
    )
    flat = load(write_glb(tree, 0.0, outside_up=False))
    np.testing.assert_allclose(flat.extents, [3e-3 * A, 0.0, 4e-3 * A], atol=1e-6)


@pytest.mark.parametrize("fraction", [0.0, 0.4, 1.0])
def test_each_corner_lies_where_the_transform_of_its_panel_puts_it(fraction: float) -> None:
    tree = folded(*cross(A, GROOVE))
    scene = load(write_glb(tree, fraction, outside_up=True))
    placed = panel_transforms(tree, np.array([fraction]))[0]
    solids = panel_solids(tree)
    expected = []
    for panel, solid in enumerate(solids):
        for z, ring in ((0.0, solid.bottom[0]), (BOARD.caliper, solid.top[0])):
            points = np.column_stack([ring, np.full(len(ring), z), np.ones(len(ring))])
            x, y, up = (points @ placed[panel].T)[:, :3].T / 1000.0
            expected.append(np.column_stack([x, up, -y]))
    corners = np.concatenate(expected)
    found = scene.to_geometry().vertices
    for some, others in ((corners, found), (found, corners)):
        apart = np.linalg.norm(some[:, None] - others[None], axis=2).min(axis=1)
        assert apart.max() < 1e-6


def test_each_panel_is_a_closed_solid_with_the_volume_of_its_board() -> None:
    square = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))
    hole = closed((20.0, 20.0), (30.0, 20.0), (30.0, 40.0), (20.0, 40.0))
    fold = edges(((60.0, 0.0), (60.0, 80.0)))
    tree = folded((CUT, square), (CUT, hole), (GROOVE, fold))
    scene = load(write_glb(tree, 0.0, outside_up=True))
    volumes = []
    for panel in range(2):
        nodes = [
            name for name in scene.graph.nodes_geometry if name.startswith(f"panel {panel + 1}")
        ]
        names = {scene.graph[name][1] for name in nodes}
        mesh: Any = trimesh.util.concatenate([scene.geometry[name] for name in names])
        mesh.merge_vertices(merge_norm=True, merge_tex=True)
        assert mesh.is_watertight
        volumes.append(mesh.volume)
    # The flank of a groove with an opening of 90° takes a triangle of caliper × caliper.
    t = BOARD.caliper
    wedge = 80.0 * t * t / 2.0
    assert sorted(volumes) == pytest.approx(
        [40.0 * 80.0 * t - wedge, (60.0 * 80.0 - 200.0) * t - wedge], rel=1e-4
    )


def test_flanks_of_a_closed_groove_meet() -> None:
    square = closed((0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0))
    tree = folded((CUT, square), (GROOVE, edges(((60.0, 0.0), (60.0, 80.0)))))
    placed = panel_transforms(tree, np.ones(1))[0]
    tops = []
    for panel, solid in enumerate(panel_solids(tree)):
        ring = solid.top[0]
        points = np.column_stack([ring, np.full(len(ring), BOARD.caliper), np.ones(len(ring))])
        tops.append((points @ placed[panel].T)[:, :3])
    apart = np.linalg.norm(tops[0][:, None] - tops[1][None], axis=2)
    assert (apart < 1e-6).sum() == 2


def test_the_animation_folds_every_panel_and_materials_name_the_faces() -> None:
    tree = folded(*cross(A))
    read = fields(write_glb(tree, 0.0, outside_up=False))
    (animation,) = read["animations"]
    assert len(animation["channels"]) == 5
    assert [one["name"] for one in read["materials"]] == ["outside", "inside", "edge"]
    turned = {channel["target"]["node"] for channel in animation["channels"]}
    assert turned | set(tree.roots) == set(range(6))


def test_a_drawing_without_blanks_is_an_empty_scene() -> None:
    tree = folded((CREASE, edges(((0.0, 0.0), (50.0, 0.0)))))
    read = fields(write_glb(tree, 1.0, outside_up=True))
    assert "meshes" not in read
    assert read["scenes"] == [{"nodes": [0]}]
