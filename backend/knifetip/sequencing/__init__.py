"""Put the tracks of a job into order, and plan the air moves between them.

A track is a path that a tool follows without lifting.
"""
