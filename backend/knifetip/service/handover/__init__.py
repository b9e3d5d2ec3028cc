"""Handover: job tickets, and drawings and tool paths as files of other programs."""
