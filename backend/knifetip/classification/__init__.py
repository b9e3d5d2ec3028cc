"""Classification: find the line type of each edge of a drawing, with the reason.

Uncertain edges stay unclassified and become questions to the user.  The package ``shape`` computes
features from geometry alone, and ``decision`` combines them with profile rules, names and colours.
``knifetip.vocabulary`` contains the words of names.  Callers use the module ``classify``.
"""
