"""Offset engine: paths of a tool's centre at a distance from contours of lines and arcs."""
