"""Simulated controllers, which listen like real ones and move a simulated machine."""
