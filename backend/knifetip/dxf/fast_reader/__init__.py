"""Reads the DXF files that CAD programs commonly write, with compiled kernels.

``scan`` stores the entities of the file in arrays, ``tables`` decodes names, layers and blocks, and
``reader`` computes the segments of all entities.  If a file cannot be read exactly as ezdxf would
read it, ``Unsupported`` is raised.
"""
