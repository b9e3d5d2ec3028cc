"""Decisions about the line type of each edge, from profile rules, shape, names and colours.

``by_rule`` and ``by_evidence`` decide; ``connectivity`` and ``symmetry`` check decisions.
"""
