"""Classification finds the line type of each edge, with the reason, and asks where it is uncertain.

The package ``shape`` computes features from geometry alone, ``decision`` combines them with profile
rules, names and colours, and ``vocabulary`` has the words of names.  Callers use ``classify``.
"""
