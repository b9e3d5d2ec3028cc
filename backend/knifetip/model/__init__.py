"""Records that the stages of the pipeline exchange: frozen dataclasses and columns of numbers."""
