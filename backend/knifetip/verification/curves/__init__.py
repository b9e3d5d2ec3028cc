"""Lines and arcs as rows of numbers, overlaps of them, and unions of intervals on them."""
