"""Read programs back: one reader for each family of controller languages."""
