"""Tools of machines: their worked length, life and changes, and their check."""
