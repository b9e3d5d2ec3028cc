"""Orders and their jobs: creation, commands, confirmation and verdicts."""
