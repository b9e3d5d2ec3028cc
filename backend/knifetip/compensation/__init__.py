"""Compensation engines, one per tool kind: head paths with which the tip follows the line."""
