"""Checks of a drawing that lies on a printed sheet by measured marks."""
