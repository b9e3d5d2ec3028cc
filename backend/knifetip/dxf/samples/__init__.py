"""Sample cartons, and a function that writes them as DXF files such as CAD programs write."""

from __future__ import annotations

from knifetip.dxf.samples.cartons import samples

__all__ = ["samples"]
