"""Floor 3: chooses tool, depth and feed for every edge."""
