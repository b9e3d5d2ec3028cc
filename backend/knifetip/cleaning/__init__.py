"""Cleaning: removes overlaps, debris and gaps from classified edges, and merges collinear edges.

The result is the dieline from which the program is made, with the outcome of every drawn edge.
"""
