"""Checks of cuts by router bits and lasers."""
