"""Checks of drawn lines that are near to each other or replaced."""
