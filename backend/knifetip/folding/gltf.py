"""gltf: the folded board as a binary glTF 2.0 file (GLB), with an animation that folds it.

Each panel is a node below the panel at which it folds, so that other programs can fold it as well.
glTF measures in metres, with Y upwards.  Specification: Khronos Group, glTF 2.0, 2021.
"""

from __future__ import annotations

import json
import math
import struct
from typing import Any, Final

import numpy as np

from knifetip.folding.records import Fold, FoldTree
from knifetip.folding.solid import Solid, panel_solids, triangulate
from knifetip.geometry.columns import F64

#: Duration of the animation (s).
_SECONDS: Final = 2.0
_FLOAT: Final = 5126
#: Colours of the faces (linear RGB): outside, inside, cut edge.
_COLOURS: Final = {
    "outside": (0.80, 0.78, 0.74),
    "inside": (0.60, 0.47, 0.33),
    "edge": (0.38, 0.26, 0.15),
}


def write_glb(tree: FoldTree, fraction: float, *, outside_up: bool) -> bytes:
    """Return the folded board of a tree as a GLB file.

    Parameters
    ----------
    tree
        The fold tree.
    fraction
        Share of its angle by which each fold has turned, 0 … 1.
    outside_up
        Whether the top face of the board is the outside of the carton.
    """
    file = _Glb(outside_up)
    moving = {tree.folds[number].child: tree.folds[number] for number in tree.order}
    pivots = np.array(
        [moving[k].axis[0] if k in moving else np.zeros(3) for k in range(len(tree.panels))]
    ).reshape(-1, 3)
    for k, solid in enumerate(panel_solids(tree)):
        node: dict[str, Any] = {
            "name": f"panel {k + 1}",
            "mesh": file.add_mesh(solid, tree.caliper, pivots[k]),
        }
        if k in moving:
            fold = moving[k]
            node["translation"] = (pivots[k] - pivots[fold.parent]).tolist()
            node["rotation"] = _quaternion(fold, fraction).tolist()
        file.nodes.append(node)
    for child, fold in moving.items():
        file.nodes[fold.parent].setdefault("children", []).append(child)
    file.add_animation(moving)
    return file.pack(tree.roots)


class _Glb:
    """A GLB file that is being put together."""

    def __init__(self, outside_up: bool) -> None:
        self.nodes: list[dict[str, Any]] = []
        names = ("inside", "outside", "edge") if outside_up else ("outside", "inside", "edge")
        self._materials = [
            {
                "name": name,
                "pbrMetallicRoughness": {
                    "baseColorFactor": [*_COLOURS[name], 1.0],
                    "metallicFactor": 0.0,
                    "roughnessFactor": 0.9,
                },
            }
            for name in names
        ]
        self._meshes: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []
        self._views: list[dict[str, Any]] = []
        self._animations: list[dict[str, Any]] = []
        self._data = bytearray()

    def add_mesh(self, solid: Solid, caliper: float, pivot: F64) -> int:
        """Add the mesh of a panel about its pivot, and return its index."""
        parts = (
            _face(triangulate(solid.bottom)[:, ::-1], 0.0),
            _face(triangulate(solid.top), caliper),
            _walls(solid, caliper),
        )
        primitives = [
            {
                "attributes": {
                    "POSITION": self._add(triangles.reshape(-1, 3) - pivot, limits=True),
                    "NORMAL": self._add(np.repeat(_normals(triangles), 3, axis=0)),
                },
                "material": material,
            }
            for material, triangles in enumerate(parts)
            if len(triangles)
        ]
        self._meshes.append({"primitives": primitives})
        return len(self._meshes) - 1

    def add_animation(self, moving: dict[int, Fold]) -> None:
        """Add the animation that folds all panels from flat to their angles."""
        if not moving:
            return
        times = self._add(np.array([0.0, _SECONDS]), limits=True)
        samplers, channels = [], []
        for child, fold in moving.items():
            turns = np.stack([_quaternion(fold, 0.0), _quaternion(fold, 1.0)])
            samplers.append({"input": times, "output": self._add(turns)})
            target = {"node": child, "path": "rotation"}
            channels.append({"sampler": len(samplers) - 1, "target": target})
        self._animations.append({"name": "fold", "samplers": samplers, "channels": channels})

    def _add(self, values: F64, *, limits: bool = False) -> int:
        """Add an array of numbers, (n,) or (n, k), and return the index of its accessor."""
        packed = np.ascontiguousarray(values, "<f4")
        accessor: dict[str, Any] = {
            "bufferView": len(self._views),
            "componentType": _FLOAT,
            "count": len(packed),
            "type": "SCALAR" if packed.ndim == 1 else f"VEC{packed.shape[1]}",
        }
        if limits:
            rows = packed.reshape(len(packed), -1)
            accessor["min"] = rows.min(axis=0).tolist()
            accessor["max"] = rows.max(axis=0).tolist()
        content = packed.tobytes()
        self._views.append({"buffer": 0, "byteOffset": len(self._data), "byteLength": len(content)})
        self._data += content
        self._accessors.append(accessor)
        return len(self._accessors) - 1

    def pack(self, roots: tuple[int, ...]) -> bytes:
        """Return the file; ``roots`` are the nodes that stay in place."""
        half = math.sqrt(0.5)
        # From mm with Z upwards to metres with Y upwards.
        scene = {"name": "board", "rotation": [-half, 0.0, 0.0, half], "scale": [0.001] * 3}
        if roots:
            scene["children"] = list(roots)
        fields = {
            "asset": {"version": "2.0", "generator": "knifetip"},
            "scene": 0,
            "scenes": [{"nodes": [len(self.nodes)]}],
            "nodes": [*self.nodes, scene],
            "meshes": self._meshes,
            "materials": self._materials,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self._data)}] if self._data else [],
            "animations": self._animations,
        }
        text = json.dumps({key: value for key, value in fields.items() if value != []}).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        if self._data:
            # All arrays have a multiple of four bytes.
            chunks += struct.pack("<II", len(self._data), 0x004E4942) + bytes(self._data)
        return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def _face(triangles: F64, z: float) -> F64:
    """Return triangles of the plane, (t, 3, 2), at a height, (t, 3, 3)."""
    return np.concatenate([triangles, np.full((*triangles.shape[:2], 1), z)], axis=2)


def _walls(solid: Solid, caliper: float) -> F64:
    """Return the triangles of the sides of a panel, (t, 3, 3)."""
    triangles = []
    for bottom, top in zip(solid.bottom, solid.top, strict=True):
        low = np.column_stack([bottom, np.zeros(len(bottom))])
        high = np.column_stack([top, np.full(len(top), caliper)])
        low_next, high_next = np.roll(low, -1, axis=0), np.roll(high, -1, axis=0)
        triangles.append(np.stack([low, low_next, high_next], axis=1))
        triangles.append(np.stack([low, high_next, high], axis=1))
    return np.concatenate(triangles)


def _normals(triangles: F64) -> F64:
    """Return the unit normal of each triangle, (t, 3)."""
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    flat = np.broadcast_to([0.0, 0.0, 1.0], normal.shape)
    result: F64 = np.where(length > 1e-12, normal / np.maximum(length, 1e-12), flat)
    return result


def _quaternion(fold: Fold, fraction: float) -> F64:
    """Return the turn of a fold as a unit quaternion (x, y, z, w)."""
    axis = fold.axis[1] - fold.axis[0]
    half = math.radians(fold.angle * fraction) / 2.0
    return np.append(math.sin(half) * axis / np.linalg.norm(axis), math.cos(half))
