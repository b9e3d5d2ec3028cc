"""Ended jobs: lists, statistics, export and deletion."""
