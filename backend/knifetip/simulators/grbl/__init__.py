"""A simulated table with the firmware of grbl or grblHAL."""
