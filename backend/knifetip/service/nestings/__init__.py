"""Nestings: searches for the places of drawings on sheets."""
