"""The checks of a program; each adds findings and figures of edges to the ``CheckContext``."""
