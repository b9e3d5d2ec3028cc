"""Controller languages: one record for each language, found by the name in a machine's TOML file.

HPGL is a controller language, and so is each dialect of RS274/NGC (LinuxCNC's and grblHAL's).  A
record names the emitter, the verifier's reader, the timing and the gateway driver of a language.
This package imports none of them, and the reader shares no code with the emitter (ADR 27).
"""
