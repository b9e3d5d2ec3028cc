"""Floor 3: choose tool, depth and feed for every edge, and the order of the work."""
