"""cf2: read CF2 files, an exchange format of die makers, into a Drawing."""
