"""Floor 3: the engines that move the head so that the tip stays on the line."""
