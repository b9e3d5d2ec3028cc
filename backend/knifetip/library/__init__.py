"""library: load machines, boards and classification profiles from TOML files."""
