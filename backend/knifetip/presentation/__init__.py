"""Plain data that the API, the command line and the store show of records."""
