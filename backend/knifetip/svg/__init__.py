"""svg: read SVG files into a Drawing."""
