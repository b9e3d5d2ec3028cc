"""Gateways: claims, heartbeats, reports and leases."""
