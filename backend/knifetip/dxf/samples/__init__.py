"""Sample cartons, and a writer of the DXF files that CAD programs write."""

from __future__ import annotations

from knifetip.dxf.samples.cartons import samples

__all__ = ["samples"]
