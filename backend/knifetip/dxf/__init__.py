"""Reads DXF, ASCII or binary, of any version; ``read`` is the only entry.

``fast_reader`` reads common files from their bytes in compiled kernels.  ``ezdxf_reader`` reads all
other files with ezdxf, and single entities for the fast reader.  ``samples`` writes DXF.
"""
