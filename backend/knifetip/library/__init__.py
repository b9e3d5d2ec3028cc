"""What is shipped: machines, boards and classification profiles, each a TOML file."""
