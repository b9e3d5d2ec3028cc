"""Shape features: the role of each edge in the drawing, computed from geometry alone.

Callers use the module ``features``; each of the other modules recognises one kind of shape.  The
planar graph and its faces come from ``knifetip.topology``.  No module here uses line types.
"""
