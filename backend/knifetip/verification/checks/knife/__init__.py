"""Checks of cuts, half-cuts and perforations by knives."""
