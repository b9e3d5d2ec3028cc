"""Floor 3: the order of the tracks, and the way between them."""
