"""Records that the stages of the pipeline exchange: frozen dataclasses and arrays of numbers."""
