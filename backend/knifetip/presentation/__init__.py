"""Presentation of records as JSON data and as columns, for REST, the command line and the store."""
