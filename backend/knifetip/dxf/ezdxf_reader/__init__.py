"""Reads any DXF file with ezdxf, which repairs many damaged files.

First, ``prescan`` counts the entities in the bytes.  Then ``document`` loads the file with ezdxf,
``expand`` expands the blocks, and ``place`` converts shapes to lines and arcs.
"""
