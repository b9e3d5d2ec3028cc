"""The checks that a program must pass; each adds findings, and measured figures of each edge."""
