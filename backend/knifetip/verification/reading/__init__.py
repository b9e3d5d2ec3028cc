"""Readers that convert programs back to moves: one for HPGL, one for all dialects of RS274/NGC."""
