"""Transports: one module for each scheme of a controller's address, with ``open_transport``."""
