"""Build the planar graph of a drawing and find its faces.

The edges of the drawing are split into pieces at the points at which they meet; the graph has these
pieces and the vertices between them.  ``graph_nesting`` and ``exact_nesting`` find the face that
contains each connected component of a graph.
"""
