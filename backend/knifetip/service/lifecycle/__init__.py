"""Transitions of jobs, their events, and the queues and runs that they change."""
