"""Post-processors: write tool paths as programs in the languages of controllers."""
