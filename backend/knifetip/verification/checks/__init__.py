"""The checks that a program must pass; each adds findings and figures to the verdict."""
