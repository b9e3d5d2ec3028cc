"""Compile jobs: the queue, the service that compiles, and the stored results."""
