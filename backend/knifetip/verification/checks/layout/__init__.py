"""Checks of what was put together on a sheet against the drawings that were placed."""
