"""Readers that convert programs back to moves, one for each family of controller languages."""
