"""The planar graph of a drawing: vertices, half-edges, faces, and what lies inside what."""
