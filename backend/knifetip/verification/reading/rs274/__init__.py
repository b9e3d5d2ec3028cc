"""Reader of RS274/NGC programs, for the subset of the language that LinuxCNC and grblHAL share."""
