"""Floor 3: beside the table, streams programs to controllers."""
