"""Job tickets: the sheet of paper that goes with a job from the office to the machine."""
