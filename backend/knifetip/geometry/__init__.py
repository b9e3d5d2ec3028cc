"""Geometry of lines and arcs, stored in arrays with one row per line or arc."""
