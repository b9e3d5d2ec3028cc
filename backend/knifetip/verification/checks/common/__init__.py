"""What several checks use: their context and base, passes, bridges and stray work."""
