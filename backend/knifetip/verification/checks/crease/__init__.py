"""Checks of creases and crease wheels."""
