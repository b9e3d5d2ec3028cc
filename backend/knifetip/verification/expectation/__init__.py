"""The paths and depths that the drawn edges require of the tools, and their limits."""
