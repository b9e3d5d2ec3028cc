"""cf2: read CF2 files into a Drawing."""
