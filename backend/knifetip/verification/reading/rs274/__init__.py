"""Reader of RS274/NGC programs that use only words which both LinuxCNC and grblHAL accept."""
