"""Parametric cartons: standard styles that are drawn from inner dimensions, options and a board.

``registry.STYLES`` lists the styles.  A style is a record with the pydantic model of its parameters
and a function that draws a ``Carton``: cuts, folds with the angle at which they end, and panels.
The drawings are our own; ``allowances`` has what the thickness of the board adds, with sources.
"""
