"""Reads the DXF files that CAD programs commonly write, in compiled kernels.

    bytes -> Scan -> Tables -> columns -> report rows, segments, annotations

A file that it cannot read exactly as ezdxf would raises ``Unsupported``.
"""
