"""Floor 3: writes the program in the controller's words."""
