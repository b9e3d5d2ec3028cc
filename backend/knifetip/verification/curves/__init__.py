"""Lines and arcs in rows, and where they run along each other."""
