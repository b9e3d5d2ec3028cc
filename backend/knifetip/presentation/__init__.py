"""Presentation of records as JSON data and packed arrays.

REST, the command line and the store use the same presentation.
"""
