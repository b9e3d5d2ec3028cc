"""Lines and arcs as rows of numbers, their overlaps with edges, and unions of intervals on them."""
