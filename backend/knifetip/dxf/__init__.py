"""Reads DXF files, ASCII or binary, of any version; other packages call ``dxf.read`` only.

``fast_reader`` reads common files with compiled kernels.  ``ezdxf_reader`` reads all other files
with ezdxf, and single entities for the fast reader.  ``samples`` writes DXF files.
"""
