"""The judge's reader of RS274/NGC, as LinuxCNC and grblHAL have it in common."""
