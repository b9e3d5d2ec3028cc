"""The work that the drawn edges require of the tools, and the limits of that work."""
