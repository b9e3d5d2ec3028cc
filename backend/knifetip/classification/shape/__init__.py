"""Shape features: the role of each edge in the drawing, computed from geometry alone.

``features`` is the entry; the other modules each recognise one kind of shape.  The planar graph and
its faces come from ``knifetip.topology``.  No module here uses line types.
"""
