"""Requests and responses of the REST API as pydantic models.

Lengths are in mm, angles in degrees, durations in seconds, times in RFC 3339 (see ``times``).
"""
