"""Reads DXF files, ASCII or binary, of any version; other packages call ``dxf.read`` only.

``fast_reader`` reads common files with compiled kernels.  ``ezdxf_reader`` reads all other files
with the library ezdxf, and single entities that the fast reader does not support.  ``samples``
writes sample cartons as DXF files.
"""
