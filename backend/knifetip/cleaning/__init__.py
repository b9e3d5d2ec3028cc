"""Cleaning of classified edges: remove overlaps and debris, close gaps, merge collinear edges."""
