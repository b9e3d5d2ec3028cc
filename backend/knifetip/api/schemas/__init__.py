"""Requests and answers of the REST API: the only words that are spoken at this door.

Lengths are mm, angles degrees, times seconds since 1970 (UTC) or durations in seconds.
"""
