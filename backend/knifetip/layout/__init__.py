"""Blanks as areas, for what is laid out, measured and priced by area."""
