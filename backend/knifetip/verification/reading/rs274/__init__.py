"""Reader of RS274/NGC programs, for the subset that LinuxCNC and grblHAL share."""
