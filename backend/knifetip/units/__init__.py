"""units: which unit a drawing is in, from all that it says, and the drawing in that unit."""
