"""The last step of every reader: from segments and styles to a Drawing with its import report."""
