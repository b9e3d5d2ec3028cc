"""Layouts: sheets with placed drawings, which are ordered like drawings."""
