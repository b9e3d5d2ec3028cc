"""units: find the unit of a drawing from several kinds of evidence, and convert it to mm."""
