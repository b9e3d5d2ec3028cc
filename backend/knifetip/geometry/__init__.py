"""Geometry of lines and arcs, in arrays with one row per segment."""
