"""Driver for controllers with the protocol of grbl 1.1, such as grblHAL."""
