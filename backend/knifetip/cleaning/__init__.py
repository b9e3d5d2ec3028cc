"""Cleaning: removes overlaps, debris and gaps from classified edges, and merges collinear edges."""
