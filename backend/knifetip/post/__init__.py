"""Post-processors: write programs from toolpaths, one emitter for each controller language."""
