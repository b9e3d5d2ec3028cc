"""Floor 3: PDF bytes in, Drawing out."""
