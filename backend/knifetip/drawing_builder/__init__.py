"""Build a Drawing with its import report from the segments and styles of a format reader."""
