"""Floor 3: write programs in the languages of controllers."""
