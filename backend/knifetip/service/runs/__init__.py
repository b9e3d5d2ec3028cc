"""A job on its machine: checks before it, its claim, its end and where it stopped."""
