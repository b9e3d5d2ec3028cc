"""The checks of a program; each adds findings, and measured figures of each edge."""
