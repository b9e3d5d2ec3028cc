"""Plane geometry on NumPy columns: lines, arcs, paths.  No state, no I/O, nothing about cartons."""
