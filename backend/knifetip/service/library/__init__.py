"""Import formats, machines, boards and tools, also those that users make."""
