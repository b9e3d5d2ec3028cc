"""Emitter for RS274/NGC, the G-code of LinuxCNC and grblHAL."""
