"""Stations of machines, operations of persons at them, and why jobs wait."""
