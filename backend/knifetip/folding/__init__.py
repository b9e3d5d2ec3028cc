"""Fold the blanks of a drawing in space along its creases and V-grooves.

``panels`` divides the blanks into panels, ``tree`` orders the panels by their folds, ``motion``
computes where the panels lie, ``findings`` what is wrong when the blanks are folded, and ``gltf``
writes the folded board as a file.  ``backend/docs/folding.md`` has the formulas and the limits.
"""
