"""Planning: chooses tool, depth and feed for every edge, and the order of machining."""
