"""Reads the DXF files that CAD programs commonly write, with compiled kernels.

``scan`` reads the bytes into arrays, ``tables`` the names, layers and blocks, and ``reader`` places
the segments of all entities.  If a file cannot be read exactly as ezdxf would read it,
``Unsupported`` is raised.
"""
