"""Floor 3: the independent judge of the emitted bytes."""
