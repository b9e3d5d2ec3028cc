"""Sample cartons, and a function that writes them as DXF files like those of CAD programs."""

from __future__ import annotations

from knifetip.dxf.samples.cartons import samples

__all__ = ["samples"]
