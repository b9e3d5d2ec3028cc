"""Floor 3: says of every edge what it is, and by which rule."""
