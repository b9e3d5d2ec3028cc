"""Programs in RS274/NGC, as LinuxCNC and grblHAL read it."""
