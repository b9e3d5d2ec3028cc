"""Cleaning: what is drawn twice, broken up, left open or lost, put in order; and a report of it."""
