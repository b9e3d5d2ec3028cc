"""Decisions about the line type of each edge, from profile rules, shape, names and colours.

The module ``classifier`` combines the evidence; ``connectivity`` and ``symmetry`` check decisions.
"""
