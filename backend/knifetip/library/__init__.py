"""library: machines, boards and classification profiles, each a TOML file."""
