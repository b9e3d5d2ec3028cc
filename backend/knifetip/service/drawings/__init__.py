"""Drawings: upload, answers, stored interpretations and their documents."""
