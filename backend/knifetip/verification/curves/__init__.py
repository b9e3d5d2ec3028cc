"""Lines and arcs as rows of numbers, their overlaps, and unions of intervals on them."""
