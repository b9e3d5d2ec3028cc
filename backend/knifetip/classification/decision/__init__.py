"""Decisions: the line type of each edge, from profile rules, shape features, names and colours.

``classifier`` combines the evidence; ``connectivity`` and ``symmetry`` check its decisions.
"""
