"""Gateway: the program on a computer beside a machine that streams jobs to the controller."""
