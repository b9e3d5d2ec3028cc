"""Reads any DXF file with the library ezdxf, which repairs many damaged files.

First, ``prescan`` counts the entities in the bytes of the file.  Then ``document`` loads the file
with ezdxf, ``expand`` replaces INSERTs by the entities of their blocks, and ``place`` converts the
shapes of the entities to lines and arcs.
"""
