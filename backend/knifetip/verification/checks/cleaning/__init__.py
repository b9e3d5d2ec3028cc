"""Checks of the cleaned edges against the drawn ones."""
