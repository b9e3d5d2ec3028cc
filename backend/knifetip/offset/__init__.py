"""The offset engine: paths of the centre of a round tool beside contours, arcs as arcs."""
