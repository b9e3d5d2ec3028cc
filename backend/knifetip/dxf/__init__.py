"""Floor 3: DXF bytes in, Drawing out."""
