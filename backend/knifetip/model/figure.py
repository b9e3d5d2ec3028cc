"""Records of a figure: lines and arcs in layers, as they are exported and printed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64


class FigureLayer(NamedTuple):
    """A layer of a figure: n lines and arcs of the same appearance."""

    name: str  #: of the layer in DXF and SVG files: letters, digits and hyphens
    colour: str  #: #rrggbb
    aci: int  #: number of the colour in DXF files (AutoCAD Color Index)
    dashes: tuple[float, ...]  #: lengths of dashes and gaps (mm on paper); empty for a solid line
    ends: F64  #: (n, 2, 2) start and end of each edge
    bulge: F64  #: (n,) tan(sweep / 4); 0 for a line


class Figure(NamedTuple):
    """Lines and arcs in layers."""

    layers: tuple[FigureLayer, ...]
    unit: str = "mm"  #: unit of the coordinates; empty if it is not known

    @property
    def edge_count(self) -> int:
        """Number of lines and arcs."""
        return sum(len(layer.bulge) for layer in self.layers)

    @property
    def box(self) -> tuple[F64, F64]:
        """Lower left and upper right corner of all lines and arcs, (2,) each; 0 without any."""
        boxes = [
            arc.bounding_boxes(layer.ends[:, 0], layer.ends[:, 1], layer.bulge).reshape(-1, 4)
            for layer in self.layers
        ]
        joined = np.concatenate([np.zeros((0, 4)), *boxes])
        if len(joined) == 0:
            return np.zeros(2), np.zeros(2)
        return joined[:, :2].min(axis=0), joined[:, 2:].max(axis=0)

    def longest(self, most: int) -> Figure:
        """Return the figure with at most ``most`` lines and arcs; the shortest are left out."""
        if self.edge_count <= most:
            return self
        lengths = [
            arc.length(layer.ends[:, 0], layer.ends[:, 1], layer.bulge) for layer in self.layers
        ]
        joined = np.concatenate(lengths)
        kept = np.zeros(len(joined), bool)
        kept[np.argsort(joined, kind="stable")[-most:]] = True
        parts = np.split(kept, np.cumsum([len(one) for one in lengths])[:-1])
        return self._replace(
            layers=tuple(
                layer._replace(ends=layer.ends[part], bulge=layer.bulge[part])
                for layer, part in zip(self.layers, parts, strict=True)
            )
        )
