"""A job is a finished, verified program and a machine."""
