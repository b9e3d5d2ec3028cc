"""Floor 2: the records that travel down the corridor, frozen columns that decide nothing."""
