"""Reads any DXF file with ezdxf, which repairs many damaged files.

The entities are counted in the bytes first (``prescan``); then ezdxf loads the file (``document``),
blocks are expanded (``expand``), and shapes become lines and arcs (``place``).
"""
