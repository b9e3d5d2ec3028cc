"""Records that the stages exchange: frozen columns and values without behaviour of a stage."""
