"""Floor 3: SVG bytes in, Drawing out."""
