"""Import of project files of LightBurn (.lbrn2 and .lbrn)."""
