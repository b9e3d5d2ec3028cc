"""Floor 1: plane geometry on NumPy columns.  No state, no I/O, nothing of cartons."""
