"""Spatial indexes: a packed tree of bounding boxes, and lists of boxes and points by cell.

``box_tree`` finds bounding boxes that overlap, and so does ``box_grid`` for boxes of similar size.
``box_pairs`` finds all pairs with the index that suits the boxes.  ``cells`` groups points by the
cells of a uniform grid, for searches that remove points or stop at the nearest point.  ``morton``
orders points so that near ones follow one another.  Decision record 31 has the measured reasons for
each.
"""
