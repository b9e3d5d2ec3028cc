"""Gateways: computers beside a machine, which stream its programs to its controller."""
