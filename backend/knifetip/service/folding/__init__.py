"""Drawings folded in space: answers for the page, and files for other programs."""
