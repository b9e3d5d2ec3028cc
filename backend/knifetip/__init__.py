"""knifetip puts the tip of the knife on the line."""
