"""Checks of V-grooves and their flanks."""
