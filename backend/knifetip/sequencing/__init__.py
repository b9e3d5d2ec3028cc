"""Floor 3: order the tracks, and plan the air moves between them."""
