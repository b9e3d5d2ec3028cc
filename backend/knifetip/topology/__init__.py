"""The planar graph of a drawing: vertices, pieces of edges, faces, and which face contains what."""
