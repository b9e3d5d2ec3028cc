"""Checks of the order of work, and of work of an earlier program."""
