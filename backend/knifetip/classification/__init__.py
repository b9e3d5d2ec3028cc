"""Classification: the line type of each edge, with the reason; questions where it is uncertain.

``shape`` computes features from geometry alone; ``decision`` combines them with profile rules,
names and colours; ``vocabulary`` has the words of names.  ``classify`` is the entry.
"""
