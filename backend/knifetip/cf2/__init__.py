"""Floor 3: CF2 bytes in, Drawing out."""
