"""Composes a server and starts it: the application, and all parts in one process."""
