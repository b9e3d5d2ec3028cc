"""pdf: read PDF files into a Drawing."""
