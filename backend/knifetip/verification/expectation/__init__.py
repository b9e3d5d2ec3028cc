"""The tool paths and depths that the drawn edges require, and the limits of the paths."""
