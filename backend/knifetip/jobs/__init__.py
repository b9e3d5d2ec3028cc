"""Stores drawings, jobs, profiles and events; moves jobs between states and compiles them."""
