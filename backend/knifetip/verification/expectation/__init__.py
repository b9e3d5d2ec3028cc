"""What the drawn edges require of the tools."""
